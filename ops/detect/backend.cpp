#include "ops/detect/backend.h"

#include <cmath>

#include "core/base/error.h"
#include "raster/software_zlists.h"

namespace trivet {
namespace {

// A wavy closed surface of rings x segments about the origin; made with libm, which decides
// nothing: both sides of the comparison see the same vertices.
std::shared_ptr<const Shape> wavy_shape(int rings, int segments, double wave) {
  const auto at = [&](int i, int j) -> Vec3 {
    const double t = M_PI * i / rings, p = 2 * M_PI * (j % segments) / segments;
    const double r = 1 + wave * std::sin(3 * t) * std::cos(2 * p);
    return r * Vec3(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t));
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < segments; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return make_shape(weld(triangles));
}

bool same(const FirstContact& a, const FirstContact& b) {
  if (a.status != b.status) return false;
  return a.status == FirstContact::Status::Free ||
         (a.time == b.time && a.moving == b.moving && a.fixed == b.fixed &&
          a.face_moving == b.face_moving && a.face_fixed == b.face_fixed && a.gap == b.gap);
}

std::string wrong_answer(ZListStage& stage, const FirstContactQuery& query) {
  Proposal proposal;
  const FirstContact found = first_contact(query, stage, &proposal);
  if (!proposal.usable) return "no proposal: " + proposal.why;
  const FirstContact truth = first_contact(query);
  const double time = truth.status == FirstContact::Status::Free ? kInfinity : truth.time;
  if (proposal.upper < time || std::min(proposal.lower, kInfinity) > time) return "wrong bounds";
  return same(found, truth) ? "" : "another answer than box trees";
}

std::unique_ptr<ZListStage> gpu_stage(const BackendOptions& options) {
  std::string why;
  try {
    if (!options.make_gpu_stage)
      throw Error(Error::Kind::Environment, "this build has no GPU support");
    std::unique_ptr<ZListStage> stage = options.make_gpu_stage();
    why = self_test(*stage);
    if (why.empty()) return stage;
    why = stage->name() + " fails its self-test: " + why;
  } catch (const Error& error) {
    why = error.what();
  }
  if (options.note) options.note(why + "; z-lists in software are used instead of the GPU");
  return nullptr;
}

std::unique_ptr<ZListStage> software_stage(const BackendOptions& options) {
  SoftwareZListOptions software;
  software.num_threads = options.num_threads;
  return std::make_unique<SoftwareZLists>(software);
}

}  // namespace

Backend backend_from_name(const std::string& name) {
  if (name == "auto") return Backend::Auto;
  if (name == "gpu") return Backend::Gpu;
  if (name == "software") return Backend::Software;
  if (name == "bvh") return Backend::Bvh;
  throw Error(Error::Kind::BadInput,
              "backend \"" + name + "\" is not accepted; accepted: auto, gpu, software, bvh");
}

std::unique_ptr<Detector> make_detector(const BackendOptions& options) {
  if (options.backend == Backend::Gpu)
    if (std::unique_ptr<ZListStage> stage = gpu_stage(options))
      return std::make_unique<Detector>(std::move(stage), "gpu");
  if (options.backend == Backend::Gpu || options.backend == Backend::Software)
    return std::make_unique<Detector>(software_stage(options), "software");
  return std::make_unique<Detector>();
}

std::string self_test(ZListStage& stage) {
  const std::shared_ptr<const Shape> a = wavy_shape(9, 14, 0.2), b = wavy_shape(12, 20, 0.3);
  const Pose fixed_pose{Rotation{0.9, 0.2, -0.3, 0.1}.normalized(), {0, 0, 0}};
  const Body fixed(*b, world_from_object(fixed_pose, UpAxis::Z, 2));
  for (int i = 0; i < 8; ++i) {
    const Pose pose{Rotation{0.7, 0.1 * i, 0.4, -0.2}.normalized(), {0.4 * i - 1.2, 0.3, 4.0}};
    const Body moving(*a, world_from_object(pose, UpAxis::Z, 0.6));
    FirstContactQuery query{{&moving, 1}, {&fixed, 1}, false, {}, {1e-6}};
    query.motion = i % 2 ? Motion::rotation({0, -3, 1}, Vec3(-1, 0.1 * i, 0.2).normalized(), 1)
                         : Motion::translation(Vec3(0.05 * i, 0.1, -1).normalized(), 8);
    const std::string wrong = wrong_answer(stage, query);
    if (!wrong.empty()) return wrong;
  }
  return "";
}

}  // namespace trivet
