#include "ops/free_places/exact_places.h"

#include <algorithm>

#include "core/contact/first_contact.h"
#include "ops/free_places/distance_query.h"

namespace trivet {
namespace {

// More than a contact's tolerance: PUT does not take what is only so far away for a contact.
constexpr double kClearOfOthers = 8;  // clearances
constexpr size_t kMaxFirst = 1024;    // places of the height maps that are tried as the first
constexpr size_t kMaxFollowed = 256;  // of those nearly as near, apart from each other

bool over_triangle(const Triangle& t, const Vec2& p) {
  // The point is inside if it is on one side of all edges, seen from above.
  double signs[3];
  for (int k = 0; k < 3; ++k) {
    const Vec2 a = t[k].head<2>() - p, b = t[(k + 1) % 3].head<2>() - p;
    signs[k] = a.x() * b.y() - a.y() * b.x();
  }
  return (signs[0] >= 0 && signs[1] >= 0 && signs[2] >= 0) ||
         (signs[0] <= 0 && signs[1] <= 0 && signs[2] <= 0);
}

}  // namespace

// A fitting place, seen from the point.
struct ExactPlaces::Found {
  Vec2 direction;  // unit
  double radius;
};

ExactPlaces::ExactPlaces(const Scene& scene, ObjectId object, std::span<const ObjectId> carried,
                         const PlaceRequest& request, double clearance)
    : m_setting(scene, object, carried, request, clearance),
      m_rotation(request.rotation),
      m_near(request.near.value_or(Vec2::Zero())),
      m_keep(request.keep + kClearOfOthers * clearance),
      m_tolerance(
          std::max(kPlaceTolerance * m_setting.width(), kPlaceToleranceClearances * clearance)),
      m_lowest(std::min(0.0, m_setting.others.box().lower.z())) {
  if (m_setting.support) m_lowest = std::min(m_lowest, m_setting.support->world_box.lower.z());
}

bool ExactPlaces::over_support(const Vec2& at) const {
  if (m_setting.on_floor()) return true;
  const Body& support = *m_setting.support;
  for (Index f = 0; f < static_cast<Index>(support.shape->mesh.triangles.size()); ++f)
    if (over_triangle(support.triangle(f), at)) return true;
  return false;
}

bool ExactPlaces::fits(const Vec2& at) const {
  if (!m_setting.region.holds(at) || !over_support(at)) return false;
  Affine world = m_setting.body.world_from_object;
  world.translation += start(at).translation;
  const Body body(*m_setting.body.shape, world);
  // The fall reaches below everything that could be met.
  const double fall = 1.01 * (body.world_box.upper.z() - m_lowest);
  Aabb below = body.world_box;
  below.lower.z() -= fall;
  const Clearance keep{m_setting.clearance};
  // The support goes first, as the smallest index wins ties.
  std::vector<Body> fixed = m_setting.others.near(below, 2 * keep.largest_stop()).bodies;
  if (m_setting.support) fixed.insert(fixed.begin(), *m_setting.support);  // wins ties
  const FirstContact found = first_contact({{&body, 1},
                                            fixed,
                                            m_setting.others.floor(),
                                            Motion::translation(-Vec3::UnitZ(), fall),
                                            keep});
  // The support has to be met first; where it stops, all others have to keep their distance.
  if (found.status != FirstContact::Status::Contact) return false;
  if (m_setting.on_floor() ? found.fixed != FirstContact::kFloor : found.fixed != 0) return false;
  world.translation.z() -= found.time;
  const Body landed(*m_setting.body.shape, world);
  for (const Body& other : m_setting.others.near(landed.world_box, 1.01 * m_keep).bodies)
    if (nearer_than(m_keep, landed, other)) return false;
  return true;
}

// Towards the point, in steps that double, then halving to what still fits.
void ExactPlaces::shrink(Found& found, double step) const {
  // Steps double while the place fits, so that far ways take few.
  double blocked = 0;
  for (;; step *= 2) {
    blocked = std::max(0.0, found.radius - step);
    if (!fits(m_near + blocked * found.direction)) break;
    found.radius = blocked;
    if (blocked == 0) return;
  }
  // The last step is halved between a place that fits and one that does not.
  while (found.radius - blocked > 0.25 * m_tolerance) {
    const double middle = 0.5 * (found.radius + blocked);
    (fits(m_near + middle * found.direction) ? found.radius : blocked) = middle;
  }
}

bool ExactPlaces::fits_on_way(const Found& found, double aside, double radius) const {
  const Vec2 across(-found.direction.y(), found.direction.x());
  return fits(m_near + radius * (found.radius * found.direction + aside * across).normalized());
}

// To a place that is nearer than all about it: towards the point, then to where, to one side or
// the other, a nearer one fits, by steps that are halved. Along a straight edge the distance grows
// with the square of what is aside, so that the first steps go as far as pixels can be off.
void ExactPlaces::descend(Found& found, double spacing) const {
  shrink(found, spacing);
  // The distance along a straight edge grows with the square of the way aside.
  const double first = spacing + std::sqrt(8 * spacing * found.radius);
  for (double step = first; step > m_tolerance && found.radius > m_tolerance; step *= 0.5)
    for (const double side : {-step, step})
      for (double nearer = found.radius - 0.25 * m_tolerance;
           nearer > 0 && fits_on_way(found, side, nearer);
           nearer = found.radius - 0.25 * m_tolerance) {
        const Vec2 across(-found.direction.y(), found.direction.x());
        found = {(found.radius * found.direction + side * across).normalized(), nearer};
        shrink(found, m_tolerance);
      }
}

// From a place that fits by the maps to one that is nearer than `best`. Nothing: there is none.
std::optional<ExactPlaces::Found> ExactPlaces::nearer(const Vec2& at, const Found& best,
                                                      double spacing) const {
  // A quarter of the tolerance is the least gain that counts.
  const double radius = best.radius - 0.25 * m_tolerance;
  const Vec2 direction = (at - m_near).normalized();
  const Vec2 across(-direction.y(), direction.x());
  for (const double aside : {0.0, -spacing, spacing}) {
    Found found{(best.radius * direction + aside * across).normalized(), radius};
    if (!fits(m_near + found.radius * found.direction)) continue;
    descend(found, spacing);
    return found;
  }
  return std::nullopt;
}

std::optional<Vec2> ExactPlaces::nearest(const Places& places) const {
  const std::vector<Pose>& starts = places.starts.empty() ? places.doubtful : places.starts;
  // The first place that fits exactly gives the radius that others have to beat.
  size_t k = 0;
  while (k < std::min(starts.size(), kMaxFirst) && !fits(centre_at(starts[k]))) ++k;
  if (k >= std::min(starts.size(), kMaxFirst)) return std::nullopt;
  std::vector<Vec2> followed{centre_at(starts[k])};
  const Vec2 first = followed[0] - m_near;
  Found best{first.normalized(), first.norm()};
  descend(best, places.spacing);
  for (; k < starts.size() && best.radius > m_tolerance; ++k) {
    const Vec2 at = centre_at(starts[k]);
    const auto close = [&](const Vec2& p) { return (p - at).norm() < 2 * places.spacing; };
    // Places of the maps come by distance: after this one none can be nearer.
    if ((at - m_near).norm() > first.norm() + 3 * places.spacing + places.doubt) break;
    // Neighbouring places would lead to the same spot.
    if (std::any_of(followed.begin(), followed.end(), close)) continue;
    if (followed.size() == kMaxFollowed) break;
    followed.push_back(at);
    if (const auto found = nearer(at, best, places.spacing)) best = *found;
  }
  return m_near + best.radius * best.direction;
}

}  // namespace trivet
