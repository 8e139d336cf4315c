#include "trivet/check.h"

#include "apps/library/scene_internal.h"
#include "ops/check/check.h"
#include "ops/stability/stability.h"

namespace trivet::v0 {
namespace {

std::vector<Check::Pair> outer(const std::vector<SceneCheck::PairFinding>& found) {
  std::vector<Check::Pair> out;
  for (const SceneCheck::PairFinding& one : found) out.push_back({one.a, one.b, one.count});
  return out;
}

Stability::Status outer(trivet::Stability::Status status) {
  switch (status) {
    case trivet::Stability::Status::Stable:
      return Stability::Status::Stable;
    case trivet::Stability::Status::Marginal:
      return Stability::Status::Marginal;
    case trivet::Stability::Status::Unstable:
      return Stability::Status::Unstable;
    case trivet::Stability::Status::Unknown:
      break;
  }
  return Stability::Status::Unknown;
}

Stability outer(const trivet::Scene& scene, const trivet::Stability& found) {
  Stability out;
  out.status = outer(found.status);
  out.why_unknown = found.why_unknown;
  out.margin = found.margin;
  for (const ObjectStability& one : found.objects) {
    if (one.topples) out.topples.push_back(scene.at(one.object).name);
    if (one.marginal) out.marginal.push_back(scene.at(one.object).name);
  }
  for (const trivet::ContactForce& one : found.forces)
    out.forces.push_back({scene.at(one.on).name, name_of(scene, one.from), v0::outer(one.point),
                          v0::outer(one.force)});
  return out;
}

}  // namespace

Check check(const Scene& scene) {
  return guarded([&] {
    const SettleOptions settle = scene.internal().settle();
    const SceneCheck found = check_scene(scene.internal().scene(), 0, settle.clearance, settle);
    Check out;
    out.crossings = outer(found.crossings);
    out.float32_crossings = outer(found.float32_crossings);
    out.contained = outer(found.contained);
    out.not_at_rest = found.not_at_rest;
    out.smallest_gap = found.smallest_gap;
    return out;
  });
}

Stability stability(const Scene& scene, std::optional<double> friction) {
  return guarded([&] {
    StabilityOptions options;
    options.friction = friction;
    options.clearance = scene.rules().clearance;
    const trivet::Scene& own = scene.internal().scene();
    return outer(own, trivet::stability(own, options));
  });
}

}  // namespace trivet::v0
