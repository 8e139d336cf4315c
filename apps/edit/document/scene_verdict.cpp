#include "apps/edit/document/scene_verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/quoted.h"
#include "ops/files/report/verdict.h"

namespace trivet::edit {
namespace {

constexpr double kArrowOfObject = 0.5;  // length, of its size
constexpr size_t kMostNames = 3;

std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g mm", 1000 * metres);
  return text;
}

std::string names_of_what_topples(const SceneSnapshot& scene, const Stability& stability) {
  std::string out;
  size_t count = 0;
  for (const ObjectStability& o : stability.objects) {
    const ObjectSnapshot* const object = o.topples ? scene.find(o.object) : nullptr;
    if (!object) continue;
    if (++count > kMostNames) continue;
    out += (out.empty() ? "" : ", ") + quoted((*object)->name);
  }
  if (count > kMostNames) out += " and " + std::to_string(count - kMostNames) + " more";
  return out;
}

}  // namespace

const ObjectStability* SceneVerdict::find(ObjectId id) const {
  const auto it = std::find_if(stability.objects.begin(), stability.objects.end(),
                               [&](const ObjectStability& o) { return o.object == id; });
  return it == stability.objects.end() ? nullptr : &*it;
}

std::optional<TopplingArrow> toppling_arrow(const Object& object, const ObjectStability& verdict) {
  if (!verdict.topples) return std::nullopt;
  const double size = object.scale * object.shape->box.diagonal();
  const Vec3 centre = object.centre_of_mass();
  // Corners of the box: where the motion of the body is fastest.
  const Affine world = object.world_from_object();
  Vec3 from = centre, fastest = verdict.motion.velocity;
  const Vec3 &low = object.shape->box.lower, &high = object.shape->box.upper;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = world.apply(
        Vec3(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z()));
    const Vec3 velocity = verdict.motion.velocity + verdict.motion.spin.cross(corner - centre);
    if (velocity.norm() > 1.01 * fastest.norm()) from = corner, fastest = velocity;
  }
  if (!(fastest.norm() > 0)) return std::nullopt;
  return TopplingArrow{from, from + kArrowOfObject * size * fastest.normalized()};
}

std::string whole_text(const SceneSnapshot& scene, const SceneVerdict& verdict) {
  const Stability& s = verdict.stability;
  switch (s.status) {
    case Stability::Status::Unstable:
      return "topples: " + names_of_what_topples(scene, s);
    case Stability::Status::Unknown:
      return "not known to stand: " + s.why_unknown;
    case Stability::Status::Marginal:
      return "stands, but only just, margin " + millimetres(s.margin);
    case Stability::Status::Stable:
      break;
  }
  return std::isfinite(s.margin) ? "stands, margin " + millimetres(s.margin) : "stands";
}

std::string object_text(const Object& object, const ObjectStability& verdict) {
  if (verdict.topples) return way_text(object, verdict.motion);
  if (verdict.marginal) return "stands, but only just";
  return "stands";
}

}  // namespace trivet::edit
