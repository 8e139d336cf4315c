// TURN/TILT [Shinya 1995, 4.1, Fig. 5]: the contact that is held gives the axis.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/contact/contact_points.h"
#include "ops/move/moves.h"
#include "ops/move/rotate_group.h"

namespace trivet {
namespace {

constexpr double kTie = 1e-9;  // of the size: the centre is over the line

struct Axis {
  Vec3 centre, direction;
};

std::string name_of(const Scene& scene, const Link& link) {
  return link.with ? scene.at(*link.with).name : "floor";
}

// The contact that is asked for; else of those that support (or, if none does, of all) the one with
// the most contact. Null: there is none.
const Link* held_link(const Scene& scene, const Object& object,
                      const std::optional<std::string>& with) {
  const Link* best = nullptr;
  const auto rank = [](const Link& link) {
    return std::make_tuple(holds_up(link.contact), link.contact.type, link.contact.normal.z());
  };
  for (const Link& link : object.links)
    if (!with || name_of(scene, link) == *with)
      if (!best || rank(link) > rank(*best)) best = &link;
  return best;
}

// Of the hull: of its area, of its longest line, of its points.
Vec3 centre_of(const Contact& contact) {
  const std::vector<Vec3>& hull = contact.hull;
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : hull) mean += p / static_cast<double>(hull.size());
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (size_t i = 0; i + 1 < hull.size() && contact.type == ContactType::Area; ++i) {
    const double twice = contact.normal.dot((hull[i] - hull[0]).cross(hull[i + 1] - hull[0]));
    sum += twice * (hull[0] + hull[i] + hull[i + 1]) / 3;
    area += twice;
  }
  return area != 0 ? Vec3(sum / area) : mean;
}

double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double t = std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0);
  return (p - a - t * d).squaredNorm();
}

// A line contact's ends; of an area the edge of its hull that is nearest to `point`.
std::array<Vec3, 2> held_line(const Contact& contact, const Vec3& point) {
  const std::vector<Vec3>& hull = contact.hull;
  std::array<Vec3, 2> best{hull[0], hull[1]};
  if (contact.type == ContactType::Line) {
    for (const Vec3& a : hull)
      for (const Vec3& b : hull)
        if ((a - b).squaredNorm() > (best[0] - best[1]).squaredNorm()) best = {a, b};
    return best;
  }
  for (size_t i = 0; i < hull.size(); ++i) {
    const Vec3 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    if (squared_distance(point, a, b) < squared_distance(point, best[0], best[1])) best = {a, b};
  }
  return best;
}

// Of the two directions of a line that which is asked for, or in which the centre of mass rises;
// where it stands over the line, that towards x (then y, then z).
Vec3 chosen_direction(const Vec3& along, const Vec3& line, const Vec3& centre, double size,
                      const std::optional<Vec3>& wanted) {
  double sign = wanted ? along.dot(*wanted) : along.cross(centre - line).z();
  if (std::abs(sign) <= kTie * (wanted ? wanted->norm() : size)) {
    sign = 0;
    for (int k = 0; k < 3 && std::abs(sign) <= kTie; ++k) sign = along[k];
  }
  return sign < 0 ? Vec3(-along) : along;
}

Axis held_axis(const MovingGroup& group, const Contact& contact, const TurnOperation& o) {
  const Vec3 centre = centre_of(contact);
  switch (o.about) {
    case TurnOperation::About::Normal:
      return {o.centre.value_or(centre), contact.normal};
    case TurnOperation::About::Line: {
      const auto [a, b] = held_line(contact, o.point.value_or(centre));
      const Vec3 along = (b - a).normalized();
      return {a, chosen_direction(along, a, group.centre(), group.size(), o.axis)};
    }
    case TurnOperation::About::Point: {
      const Vec3 near = o.point.value_or(centre);
      const auto nearest =
          std::min_element(contact.points.begin(), contact.points.end(),
                           [&](const ContactPoint& p, const ContactPoint& q) {
                             return (p.point - near).squaredNorm() < (q.point - near).squaredNorm();
                           });
      return {nearest->point, o.axis ? o.axis->normalized() : contact.normal};
    }
  }
  return {centre, contact.normal};
}

}  // namespace

OperationResult perform_turn(Scene& scene, ObjectId id, const TurnOperation& o,
                             const SettleOptions& options) {
  Attempt attempt(scene, id, o, "turn", options);
  if (attempt.refused()) return attempt.finish(ObjectState::Held);
  const Link* link = held_link(scene, attempt.group().object(), o.with);
  if (!link) {
    attempt.refuse(attempt.name() + " does not touch " +
                   (o.with ? "\"" + *o.with + "\"" : "anything") +
                   ": there is no contact to turn about");
  } else if (o.about == TurnOperation::About::Line && link->contact.hull.size() < 2) {
    attempt.refuse(attempt.name() + " touches \"" + name_of(scene, *link) +
                   "\" in one point: there is no line to turn about");
  } else {
    const Axis axis = held_axis(attempt.group(), link->contact, o);
    rotate_group(attempt, axis.centre, axis.direction, o.angle_deg, false);
    if (o.settle && !attempt.refused()) attempt.let_go();
  }
  return attempt.finish(ObjectState::Held);
}

}  // namespace trivet
