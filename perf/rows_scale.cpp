// Cost of one operation as the scene grows: only what is near counts.
#include <stdexcept>

#include "core/io/mesh_model.h"
#include "core/mesh/weld_arrays.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/operations/perform.h"
#include "ops/session/session.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/scenes.h"

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

/// A cube about the origin.
Object cube(double half) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(half * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  const std::vector<Index3> faces{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  Object out;
  out.name = "box";
  out.model = std::make_shared<const Model>(model_of_mesh(weld(corners, faces).mesh));
  out.shape = make_shape(out.model->mesh);
  return out;
}

PushOperation push_of(double distance) {
  PushOperation push;
  push.object = "box_0";
  push.distance = distance;
  return push;
}

/// Boxes that stand on the floor in rows, and "box", which is not placed.
Scene boxes_in_rows(int num) {
  Scene scene;
  Object box = cube(0.05);
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
  const PushOperation push = push_of(0.01);
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
    report.add({"PUSH by 5 cm", repeated(*scene, push_of(0.05), hash), 0, 0, ""});
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
