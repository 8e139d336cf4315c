// Cost of one operation as the scene grows: only what is near counts.
#include <stdexcept>

#include "core/io/mesh_model.h"
#include "core/mesh/weld_arrays.h"
#include "ops/operations/perform.h"
#include "perf/rows.h"
#include "perf/scale.h"

namespace trivet::perf {
namespace {

constexpr int kNumObjects[] = {100, 1'000, 10'000, 100'000};
constexpr double kSpacing = 0.25;  // metres between the centres of boxes of 0.1 m
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

/// Boxes that stand on the floor in rows, and "box", which is not placed.
Scene boxes_in_rows(int num) {
  Scene scene;
  Object box = cube(0.05);
  for (int i = 0; i < num; ++i) {
    Object one = box;
    one.name = text("box_%d", i);
    const ObjectId id = scene.add(std::move(one));
    if (const auto result = stand(scene, id, {{}, place_of(i, num)}, scale_options()); !result.ok())
      throw std::runtime_error(result.reason());
  }
  scene.add(std::move(box));
  return scene;
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
    report.add({"PUSH by 5 cm", repeated(*scene, push_of("box_0", 0.05), hash), 0, 0, ""});
    report.add_hash(hash.value());
    report.add(check_row(*scene));
    Session session(std::move(*scene), {}, {});
    report.add({"a session's step, PUSH by 1 cm", session_steps(session, "box_0"), 0, 0, ""});
  }
  real_scale_rows(report);
}

}  // namespace trivet::perf
