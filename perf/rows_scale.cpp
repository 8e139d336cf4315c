// Cost of one operation as the scene grows: only what is near counts.
#include <stdexcept>

#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/operations/perform.h"
#include "ops/session/session.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/scenes.h"
#include "tests/support/solids.h"

namespace trivet::perf {
namespace {

constexpr int kNumObjects[] = {100, 1'000, 10'000, 100'000};
constexpr int kRepetitions = 31;
constexpr double kSpacing = 0.25;  // metres between the centres of boxes of 0.1 m
// The same at all sizes: the default grows with the scene, and with it the work of a contact.
constexpr double kClearance = 2e-6;

SettleOptions options() {
  SettleOptions out;
  out.clearance = kClearance;
  return out;
}

Vec3 place_of(int i, int num) {
  const int side = static_cast<int>(std::ceil(std::sqrt(num)));
  return kSpacing * Vec3(i % side - side / 2, i / side - side / 2, 0) + Vec3(0, 0, 0.05 + 2e-6);
}

/// Boxes that stand on the floor in rows, and "box", which is not placed.
Scene boxes_in_rows(int num) {
  Scene scene;
  Object box = test::object_of("box", test::box_triangles(Vec3(0.05, 0.05, 0.05)));
  for (int i = 0; i < num; ++i) {
    Object one = box;
    one.name = text("box_%d", i);
    const ObjectId id = scene.add(std::move(one));
    if (const auto result = stand(scene, id, {{}, place_of(i, num)}, options()); !result.ok())
      throw std::runtime_error(result.reason());
  }
  scene.add(std::move(box));
  return scene;
}

/// Runs one operation again and again from the same scene.
Samples repeated(Scene& scene, const Operation& operation, ResultHash& hash) {
  Samples samples;
  for (int i = 0; i < kRepetitions; ++i) {
    Transaction trial(scene);
    OperationResult result;
    const Took took = timed([&] { result = perform(trial, operation, options()); });
    if (!result.ok()) throw std::runtime_error(result.reason());
    hash.add(scene.at(*scene.find(object_name(operation))).pose);
    trial.rollback();
    samples.add(took);
  }
  return samples;
}

Samples session_steps(Session& session) {
  Samples samples;
  const PushOperation push{{{"box_0"}}, Vec2(1, 0), 0.01};
  for (int i = 0; i < kRepetitions; ++i) {
    samples.add(timed([&] {
      if (!session.perform(push, options()).ok()) throw std::runtime_error("push is refused");
    }));
    session.undo();
  }
  return samples;
}

}  // namespace

void scale_rows(Report& report) {
  for (const int num : kNumObjects) {
    report.section(text("Boxes in rows on the floor: %s objects", short_count(num).c_str()));
    std::optional<Scene> scene;
    Samples standing;
    standing.add(timed([&] { scene = boxes_in_rows(num); }));
    report.add({"standing all of them", standing, num == 10'000 ? 5000.0 : 0, 0, ""});
    ResultHash hash;
    const Vec3 free = place_of(num / 2, num) + Vec3(0.5 * kSpacing, 0.5 * kSpacing, 0.3);
    const Rotation tilted = Rotation::about_axis(Vec3(1, 2, 3).normalized(), 0.2);
    report.add({"PUT between four of them",
                repeated(*scene, PutOperation{{"box"}, {tilted, free}, {}}, hash), 0, 0, ""});
    report.add({"PUSH by 5 cm",
                repeated(*scene, PushOperation{{{"box_0"}}, Vec2(1, 0), 0.05}, hash), 0, 0, ""});
    report.add_hash(hash.value());
    Samples check;
    SceneCheck found;
    check.add(timed([&] { found = check_scene(*scene, 1, kClearance); }));
    report.add({"check", check, 0, 0, found.ok() ? "true" : "FALSE"});
    Session session(std::move(*scene), {}, {});
    report.add({"a session's step, PUSH by 1 cm", session_steps(session), 0, 0, ""});
  }
}

}  // namespace trivet::perf
