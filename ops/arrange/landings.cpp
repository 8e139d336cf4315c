// Ways down for a thing: onto a level, into a container, from above onto all that is open.
#include <algorithm>

#include "core/base/quoted.h"
#include "ops/arrange/world.h"
#include "ops/operations/carried_with.h"

namespace trivet {
namespace {

constexpr double kAboveClearances = 4;  // of a start, in clearances
constexpr double kAboveSurface = 2e-3;  // of a start below something else, metres at most
constexpr double kAboveLevel = 1e-3;    // of what is not on the level below, metres

}  // namespace

bool is_level(size_t count, int level) {
  const int num = static_cast<int>(count);
  return level < num && level >= -num;
}

Sentence no_such_level(const std::string& support, size_t count, int level) {
  const int num = static_cast<int>(count);
  if (num == 0) return say("%1 has no surface to set things down on", quoted(support));
  if (num == 1)
    return say("%1 has 1 surface, none of which is %2; accepted: -1 to 0", quoted(support), level);
  return say("%1 has %2 surfaces, none of which is %3; accepted: %4 to %5", quoted(support), num,
             level, -num, num - 1);
}

const SupportSurface* surface_at(const std::vector<SupportSurface>& surfaces, int level) {
  if (!is_level(surfaces.size(), level)) return nullptr;
  return &surfaces[level < 0 ? static_cast<int>(surfaces.size()) + level : level];
}

std::optional<Landing> landing_on(const Scene& scene, ObjectId support,
                                  const std::vector<SupportSurface>& surfaces,
                                  const SupportSurface& surface, double height, double clearance) {
  Landing out;
  out.supports = {support};
  out.lower = surface.lower, out.upper = surface.upper;
  // The thing may not come to rest on a lower level.
  for (const SupportSurface& other : surfaces)
    if (other.highest < surface.lowest)
      out.lowest = std::max(out.lowest.value_or(-kInfinity), other.highest + kAboveLevel);
  const double above = kAboveClearances * clearance;
  // Below something else the start is just over the surface, and there has to be room for the
  // thing.
  if (surface.head_room < kInfinity) {
    const double left = surface.head_room - (surface.highest - surface.height) - height;
    if (left < 2 * above) return std::nullopt;
    out.start_z = surface.highest + std::min(0.5 * left, kAboveSurface);
  } else {
    out.start_z = scene.world_box(support).upper.z() + above;
  }
  return out;
}

namespace {

Landing landing_in(const Scene& scene, ObjectId container, double clearance) {
  Landing out;
  const Aabb box = scene.world_box(container);
  out.lower = box.lower.head<2>(), out.upper = box.upper.head<2>();
  // A thing may also come to rest on what is in the container already.
  double top = box.upper.z();
  for (const ObjectId id : carried_with(scene, container)) {
    out.supports.emplace_back(id);
    top = std::max(top, scene.world_box(id).upper.z());
  }
  out.start_z = top + kAboveClearances * clearance;
  return out;
}

// Above all, onto whatever is open from above.
Landing landing_from_above(const Scene& scene, ObjectId support, double clearance) {
  Landing out;
  const Aabb box = scene.world_box(support);
  out.supports = {support};
  out.lower = box.lower.head<2>(), out.upper = box.upper.head<2>();
  out.start_z = box.upper.z() + kAboveClearances * clearance;
  return out;
}

}  // namespace

std::vector<Landing> World::landings(const ThingModel& thing, double height,
                                     Sentence& why_none) const {
  const Relation* support = support_of(thing);
  const double clearance = this->clearance(thing);
  std::vector<Landing> out;
  if (!support || support->b == "floor") {
    if (!scene().floor) {
      why_none = TRIVET_SENTENCE("there is no floor");
      return {};
    }
    Landing landing;
    landing.supports = {Support::floor()};
    landing.start_z = kAboveClearances * clearance;
    landing.lower = Vec2::Constant(-kInfinity), landing.upper = Vec2::Constant(kInfinity);
    out.push_back(landing);
    return out;
  }
  const ObjectId id = *scene().find(support->b);
  // A container is entered from above, whatever its levels.
  if (support->as<relations::In>()) return {landing_in(scene(), id, clearance)};
  const std::vector<SupportSurface>& surfaces = this->surfaces(support->b);
  const auto add = [&](const SupportSurface& surface) {
    if (auto landing = landing_on(scene(), id, surfaces, surface, height, clearance))
      out.push_back(std::move(*landing));
  };
  // A level that is asked for is the only way down.
  if (const auto* const on = support->as<relations::On>(); on && on->level) {
    const SupportSurface* surface = surface_at(surfaces, *on->level);
    why_none = surface ? TRIVET_SENTENCE("the head room there is less than its height")
                       : no_such_level(support->b, surfaces.size(), *on->level);
    if (surface) add(*surface);
    return out;
  }
  // Without a level it may come down from above, or onto any level that something covers.
  out.push_back(landing_from_above(scene(), id, clearance));
  for (const SupportSurface& surface : surfaces)
    if (surface.head_room < kInfinity) add(surface);
  return out;
}

}  // namespace trivet
