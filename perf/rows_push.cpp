#include <stdexcept>

#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/scenes.h"

namespace trivet::perf {
namespace {

constexpr int kTables[] = {10, 67};    // tables of BREAKFAST; 67: 1M triangles
constexpr double kTableSpacing = 2.5;  // metres

Scene laid_out_breakfast() {
  DemoScene demo = make_demo_scene("breakfast");
  for (const PutOperation& o : demo.operations)
    if (!perform(demo.scene, o, test::perfect_friction()).ok())
      throw std::runtime_error(o.object + " cannot be put");
  return std::move(demo.scene);
}

/// Copies a table many times, in rows; names get a number.
Scene many_tables(const Scene& one, int count, double clearance) {
  Scene out;
  for (int i = 0; i < count; ++i)
    for (const ObjectId id : one.ids()) {
      Object object = one.at(id);
      object.name += text("_%d", i);
      object.pose.translation += kTableSpacing * Vec3(i % 8, i / 8, 0);
      object.contacts.clear();
      out.add(std::move(object));
    }
  update_contacts(out, clearance);
  return out;
}

/// Steps every free object of the first table in 8 directions, each from the same scene.
Samples push_steps(Scene& scene, const std::vector<std::string>& names, bool settle,
                   double clearance, ResultHash* hash, size_t* refused) {
  SettleOptions options = test::perfect_friction();
  options.clearance = clearance;
  Samples samples;
  for (const std::string& name : names)
    for (const Vec2& direction : kPushDirections) {
      PushOperation push;
      push.object = name, push.direction = direction, push.distance = kPushStep,
      push.settle = settle;
      Transaction trial(scene);
      OperationResult result;
      const Took took = timed([&] { result = perform(scene, push, options); });
      hash->add(scene.at(*scene.find(name)).pose);
      trial.rollback();
      if (result.ok())
        samples.add(took);
      else
        ++*refused;
    }
  return samples;
}

void add_push_rows(Scene scene, const std::vector<std::string>& names, double clearance,
                   double goal_ms, Report& report) {
  ResultHash hash;
  for (const bool settle : {false, true}) {
    size_t refused = 0;
    const Samples samples = push_steps(scene, names, settle, clearance, &hash, &refused);
    report.add({settle ? "the same, settled at the end" : "PUSH by 5 mm, held at the end", samples,
                goal_ms, 0, text("refused %zu", refused)});
  }
  report.add_hash(hash.value());
}

std::vector<std::string> free_objects(const Scene& scene, const std::string& suffix) {
  std::vector<std::string> names;
  for (const ObjectId id : scene.ids())
    if (!scene.at(id).fixed) names.push_back(scene.at(id).name + suffix);
  return names;
}

// Largest displacement of an object relative to the table.
double largest_shift(const Scene& before, const Scene& after, ObjectId table) {
  const Vec3 by = after.at(table).pose.translation - before.at(table).pose.translation;
  double largest = 0;
  for (const ObjectId id : before.ids()) {
    const Vec3 own = after.at(id).pose.translation - before.at(id).pose.translation;
    largest = std::max(largest, (own - by).cwiseAbs().maxCoeff());
  }
  return largest;
}

void add_table_rows(Scene scene, Report& report) {
  const ObjectId table = *scene.find("table");
  edit_object(scene, table, [](Object& o) { o.fixed = false; });
  if (!put(scene, table, scene.at(table).pose, test::perfect_friction()).ok())
    throw std::runtime_error("the table cannot be put");
  PushOperation push;
  push.object = "table", push.distance = 0.1;
  const TranslateOperation lift{{"table"}, Vec3(0.1, -0.05, 0.2)};
  for (const Operation& operation : {Operation(push), Operation(lift)}) {
    Samples samples;
    double shift = 0;
    size_t carried = 0;
    for (int i = 0; i < 9; ++i) {
      Scene after = scene;
      OperationResult result;
      samples.add(timed([&] { result = perform(after, operation, test::perfect_friction()); }));
      if (!result.ok()) throw std::runtime_error(result.reason());
      carried = result.carried.size();
      shift = largest_shift(scene, after, table);
    }
    report.add(
        {text("%s of the table by 0.1 m and more", op_name(operation)), samples, 10, 0,
         text("%zu objects carried; largest shift relative to the table %.2g m", carried, shift)});
  }
}

}  // namespace

void push_rows(Report& report) {
  const Scene breakfast = laid_out_breakfast();
  const double clearance = default_clearance(breakfast);
  report.section("PUSH in BREAKFAST: every object, in 8 directions");
  add_push_rows(breakfast, free_objects(breakfast, ""), clearance, 2, report);
  add_table_rows(breakfast, report);

  for (const int count : kTables) {
    Scene many = many_tables(breakfast, count, clearance);
    std::int64_t num_triangles = 0;
    for (const ObjectId id : many.ids())
      num_triangles += static_cast<std::int64_t>(many.at(id).shape->mesh.triangles.size());
    report.section(text("The same PUSHes among %zu objects, %s triangles", many.ids().size(),
                        short_count(num_triangles).c_str()));
    add_push_rows(std::move(many), free_objects(breakfast, "_0"), clearance, 10, report);
  }
}

}  // namespace trivet::perf
