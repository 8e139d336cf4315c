#include "ops/operations/turn_axis.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace trivet {
namespace {

constexpr double kOverLine = 1e-9;  // of the size: the centre is over the line

double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double t = std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0);
  return (p - a - t * d).squaredNorm();
}

// Takes, of the two directions of a line, the one that is asked for, or in which the centre of mass
// rises; where it stands over the line, that towards x (then y, then z).
Vec3 chosen_direction(const Vec3& along, const Vec3& line, const Vec3& centre, double size,
                      const std::optional<Vec3>& wanted) {
  // The side of the line on which the centre lies tells in which direction it rises.
  double sign = wanted ? along.dot(*wanted) : along.cross(centre - line).z();
  if (std::abs(sign) <= kOverLine * (wanted ? wanted->norm() : size)) {
    sign = 0;
    for (int k = 0; k < 3 && std::abs(sign) <= kOverLine; ++k) sign = along[k];
  }
  return sign < 0 ? Vec3(-along) : along;
}

}  // namespace

bool holds_more(const ObjectContact& a, const ObjectContact& b) {
  const auto rank = [](const ObjectContact& entry) {
    return std::make_tuple(holds_up(entry), entry.contact.type, entry.contact.normal.z());
  };
  return rank(a) > rank(b);
}

Vec3 centre_of(const Contact& contact) {
  const std::vector<Vec3>& hull = contact.hull;
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : hull) mean += p / static_cast<double>(hull.size());
  Vec3 sum = Vec3::Zero();
  double area = 0;
  // The centroid of the hull is that of its triangles, weighted by area.
  for (size_t i = 0; i + 1 < hull.size() && contact.type == ContactType::Area; ++i) {
    const double twice = contact.normal.dot((hull[i] - hull[0]).cross(hull[i + 1] - hull[0]));
    sum += twice * (hull[0] + hull[i] + hull[i + 1]) / 3;
    area += twice;
  }
  return area != 0 ? Vec3(sum / area) : mean;
}

std::array<Vec3, 2> held_line(const Contact& contact, const Vec3& point) {
  const std::vector<Vec3>& hull = contact.hull;
  std::array<Vec3, 2> best{hull[0], hull[1]};
  // A line's ends are the two points farthest from each other.
  if (contact.type == ContactType::Line) {
    for (const Vec3& a : hull)
      for (const Vec3& b : hull)
        if ((a - b).squaredNorm() > (best[0] - best[1]).squaredNorm()) best = {a, b};
    return best;
  }
  // An area is held at the side nearest to the point.
  for (size_t i = 0; i < hull.size(); ++i) {
    const Vec3 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    if (squared_distance(point, a, b) < squared_distance(point, best[0], best[1])) best = {a, b};
  }
  return best;
}

Vec3 held_point(const Contact& contact, const Vec3& point) {
  const auto nearest =
      std::min_element(contact.points.begin(), contact.points.end(),
                       [&](const ContactPoint& p, const ContactPoint& q) {
                         return (p.point - point).squaredNorm() < (q.point - point).squaredNorm();
                       });
  return nearest->point;
}

TurnAxis turn_axis(const Object& object, const Contact& contact, const TurnOperation& o) {
  const Vec3 centre = centre_of(contact);
  switch (o.about) {
    case TurnOperation::About::Normal:
      return {o.centre.value_or(centre), contact.normal};
    case TurnOperation::About::Line: {
      const auto [a, b] = held_line(contact, o.point.value_or(centre));
      const double size = object.scale * object.shape->box.diagonal();
      return {a, chosen_direction((b - a).normalized(), a, object.centre_of_mass(), size, o.axis)};
    }
    case TurnOperation::About::Point:
      return {held_point(contact, o.point.value_or(centre)),
              o.axis ? o.axis->normalized() : contact.normal};
  }
  return {centre, contact.normal};
}

}  // namespace trivet
