#include "ops/arrange/relations.h"

#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

constexpr double kMirroredDeg = 2;  // of a front against the mirror image of another

// The direction from b in which a lies.
Vec2 direction_of(const Relation& r, const Outline& a, const Outline& b) {
  switch (r.kind) {
    case RelationKind::LeftOf:
      return -b.right();
    case RelationKind::RightOf:
      return b.right();
    case RelationKind::InFrontOf:
      return b.front;
    case RelationKind::Behind:
      return -b.front;
    default:
      break;
  }
  switch (r.side) {  // of a, which is turned to b
    case Side::Front:
      return -a.front;
    case Side::Back:
      return a.front;
    case Side::Left:
      return a.right();
    case Side::Right:
      break;
  }
  return -a.right();
}

double outside(double value, double lower, double upper) {
  return std::max({0.0, lower - value, value - upper});
}

// Metres along which they are beside each other: of the narrower one, or of the side that is
// against something.
double wanted_overlap(const Relation& r, const Outline& a, const Outline& b, const Vec2& across) {
  const double width = a.width(across);
  return r.overlap * (r.kind == RelationKind::Against ? width : std::min(width, b.width(across)));
}

double beside_cost(const Relation& r, const Outline& a, const Outline& b) {
  const Vec2 d = direction_of(r, a, b), across = quarter_turned(d);
  const double gap = -extent(a.hull, -d) - extent(b.hull, d);
  const double wanted = wanted_overlap(r, a, b, across);
  const double overlap = std::min(extent(a.hull, across), extent(b.hull, across)) +
                         std::min(extent(a.hull, -across), extent(b.hull, -across));
  return std::max(outside(gap, r.lower, r.upper), std::max(0.0, wanted - overlap)) / r.tolerance;
}

double centred_cost(const Relation& r, const Outline& a, const Outline& b) {
  const Vec2 off = a.centre - b.centre;
  const double x = std::abs(off.dot(b.right()) - r.offset.x());
  const double y = std::abs(off.dot(-b.front) - r.offset.y());
  return std::max(r.along_x ? x : 0, r.along_y ? y : 0) / r.tolerance;
}

double within_cost(const Relation& r, const Outline& a) {
  double out = 0;
  for (size_t i = 0; i < r.region.size(); ++i) {
    const Vec2 along = (r.region[(i + 1) % r.region.size()] - r.region[i]).normalized();
    const Vec2 outwards = -quarter_turned(along);
    out = std::max(out, extent(a.hull, outwards) - outwards.dot(r.region[i]));
  }
  return out / r.tolerance;
}

Vec2 mirrored_direction(const Relation& r, const Vec2& v) { return 2 * v.dot(r.axis) * r.axis - v; }

Vec2 mirrored_point(const Relation& r, const Vec2& p) {
  return *r.point + mirrored_direction(r, p - *r.point);
}

double symmetric_cost(const Relation& r, const Outline& a, const Outline& b) {
  const double off = (a.centre - mirrored_point(r, b.centre)).norm();
  const double turned = angle_between_deg(a.front, mirrored_direction(r, b.front));
  return std::max(off / r.tolerance, turned / kMirroredDeg);
}

// Degrees between two directions but for turns of this many degrees.
double turned_from(const Vec2& a, const Vec2& b, double period_deg) {
  const double angle = angle_between_deg(a, b);
  return std::abs(angle - period_deg * std::floor(angle / period_deg + 0.5));
}

// lower <= (sign p + known) . d <= upper, of the position p.
void add_interval(const Vec2& d, double sign, double known, double lower, double upper,
                  std::vector<HalfPlane>& out) {
  if (upper < kInfinity) out.push_back({sign * d, upper - known});
  if (lower > -kInfinity) out.push_back({-sign * d, known - lower});
}

}  // namespace

double relation_cost(const Relation& r, const Outline& a, const Outline* b) {
  switch (r.kind) {
    case RelationKind::On:
    case RelationKind::In:
      return 0;
    case RelationKind::Against:
    case RelationKind::LeftOf:
    case RelationKind::RightOf:
    case RelationKind::InFrontOf:
    case RelationKind::Behind:
      return beside_cost(r, a, *b);
    case RelationKind::Near:
      return outside(distance(a.hull, b->hull, r.lower > 0 ? 0 : r.upper), r.lower, r.upper) /
             r.tolerance;
    case RelationKind::Facing:
    case RelationKind::Away:
      return angle_between_deg(a.front, wanted_front(r, a, b)) / r.tolerance;
    case RelationKind::Aligned:
      return turned_from(a.front, b->front, 90) / r.tolerance;
    case RelationKind::Parallel:
      return turned_from(a.front, b->front, 180) / r.tolerance;
    case RelationKind::Same:
      return angle_between_deg(a.front, b->front) / r.tolerance;
    case RelationKind::Centred:
      return centred_cost(r, a, *b);
    case RelationKind::Within:
      return within_cost(r, a);
    case RelationKind::At:
      return (a.centre - *r.point).norm() / r.tolerance;
    case RelationKind::Symmetric:
      return symmetric_cost(r, a, *b);
  }
  return 0;
}

namespace {

std::vector<HalfPlane> beside_planes(const Relation& r, const Outline& moving, const Outline& other,
                                     bool moves_a, double slack) {
  const Outline &a = moves_a ? moving : other, &b = moves_a ? other : moving;
  const double sign = moves_a ? 1 : -1;  // a - b
  const Vec2 d = direction_of(r, a, b), across = quarter_turned(d);
  std::vector<HalfPlane> out;
  add_interval(d, sign, -extent(a.hull, -d) - extent(b.hull, d), r.lower - slack, r.upper + slack,
               out);
  const double wanted = wanted_overlap(r, a, b, across) - slack;
  // Nowhere, where either is too narrow for that.
  const double room = std::min(a.width(across), b.width(across));
  if (wanted > room) out.push_back({Vec2::Zero(), room - wanted});
  // The end of a beyond b's beginning, and the beginning of a before b's end.
  add_interval(across, sign, extent(a.hull, across) + extent(b.hull, -across), wanted, kInfinity,
               out);
  add_interval(across, sign, -extent(a.hull, -across) - extent(b.hull, across), -kInfinity, -wanted,
               out);
  return out;
}

std::vector<HalfPlane> near_planes(const Relation& r, const Outline& moving, const Outline& other,
                                   double slack) {
  std::vector<HalfPlane> out;
  const double s = std::sqrt(0.5);
  for (const Vec2& d : {Vec2(1, 0), Vec2(s, s), Vec2(0, 1), Vec2(-s, s), Vec2(-1, 0), Vec2(-s, -s),
                        Vec2(0, -1), Vec2(s, -s)})
    add_interval(d, 1, -extent(moving.hull, -d) - extent(other.hull, d), -kInfinity,
                 r.upper + slack, out);
  return out;
}

std::vector<HalfPlane> planes_about(const Vec2& at, double slack) {
  std::vector<HalfPlane> out;
  out.reserve(4);
  for (const Vec2& d : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
    out.push_back({d, d.dot(at) + slack});
  return out;
}

std::vector<HalfPlane> centred_planes(const Relation& r, const Outline& moving,
                                      const Outline& other, bool moves_a, double slack) {
  const Outline &a = moves_a ? moving : other, &b = moves_a ? other : moving;
  const double sign = moves_a ? 1 : -1;
  const Vec2 off = a.centre - b.centre;
  std::vector<HalfPlane> out;
  const auto add = [&](const Vec2& d, double wanted) {
    add_interval(d, sign, off.dot(d), wanted - slack, wanted + slack, out);
  };
  if (r.along_x) add(b.right(), r.offset.x());
  if (r.along_y) add(-b.front, r.offset.y());
  return out;
}

}  // namespace

std::vector<HalfPlane> half_planes(const Relation& r, const Outline& moving, const Outline* other,
                                   bool moves_a, double more) {
  const double slack = 0.5 * r.tolerance + more;
  std::vector<HalfPlane> out;
  switch (r.kind) {
    case RelationKind::Against:
    case RelationKind::LeftOf:
    case RelationKind::RightOf:
    case RelationKind::InFrontOf:
    case RelationKind::Behind:
      return beside_planes(r, moving, *other, moves_a, slack);
    case RelationKind::Near:
      return near_planes(r, moving, *other, slack);
    case RelationKind::Centred:
      return centred_planes(r, moving, *other, moves_a, slack);
    case RelationKind::Within:
      for (size_t i = 0; i < r.region.size(); ++i) {
        const Vec2 along = (r.region[(i + 1) % r.region.size()] - r.region[i]).normalized();
        const Vec2 outwards = -quarter_turned(along);
        out.push_back(
            {outwards, outwards.dot(r.region[i]) + slack - extent(moving.hull, outwards)});
      }
      return out;
    case RelationKind::At:
      return planes_about(*r.point - moving.centre, slack);
    case RelationKind::Symmetric:
      return planes_about(mirrored_point(r, other->centre) - moving.centre, slack);
    default:
      return out;
  }
}

bool separates(const Relation& r) {
  switch (r.kind) {
    case RelationKind::Against:
    case RelationKind::LeftOf:
    case RelationKind::RightOf:
    case RelationKind::InFrontOf:
    case RelationKind::Behind:
      return r.is_hard() && r.lower >= 0;
    default:
      return false;
  }
}

Rotation turn_between(const Vec2& from, const Vec2& to) {
  const double cosine = from.dot(to);
  if (1 + cosine < 1e-12) return {0, 0, 0, 1};
  return Rotation{1 + cosine, 0, 0, cross(from, to)}.normalized();
}

std::vector<Rotation> turns_asked_for(const Relation& r, const Outline& moving,
                                      const Outline& other) {
  if (r.kind == RelationKind::Symmetric)
    return {turn_between(moving.front, mirrored_direction(r, other.front))};
  int step = 0;  // quarter turns
  switch (r.kind) {
    case RelationKind::Against:
    case RelationKind::Aligned:
      step = 1;
      break;
    case RelationKind::Parallel:
      step = 2;
      break;
    case RelationKind::Same:
      step = 4;
      break;
    default:
      return {};
  }
  std::vector<Rotation> out;
  Vec2 wanted = other.front;
  for (int quarter = 0; quarter < 4; ++quarter, wanted = quarter_turned(wanted))
    if (quarter % step == 0) out.push_back(turn_between(moving.front, wanted));
  return out;
}

Vec2 wanted_front(const Relation& r, const Outline& a, const Outline* b) {
  if (r.kind != RelationKind::Facing && r.kind != RelationKind::Away) return Vec2::Zero();
  const Vec2 to = (r.point ? *r.point : b->centre) - a.centre;
  const double length = to.norm();
  if (!(length > 0)) return a.front;
  return r.kind == RelationKind::Facing ? Vec2(to / length) : Vec2(-to / length);
}

}  // namespace trivet
