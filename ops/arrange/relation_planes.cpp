// Windows and turns that relations leave.
#include <algorithm>
#include <cmath>

#include "ops/arrange/relation_parts.h"

namespace trivet {
namespace {

// lower <= (sign p + known) . d <= upper, of the position p.
void add_interval(const Vec2& d, double sign, double known, double lower, double upper,
                  std::vector<HalfPlane>& out) {
  if (upper < kInfinity) out.push_back({sign * d, upper - known});
  if (lower > -kInfinity) out.push_back({-sign * d, known - lower});
}

std::vector<HalfPlane> beside_planes(const Relation& r, const Outline& moving, const Outline& other,
                                     bool moves_a, double slack) {
  const Outline &a = moves_a ? moving : other, &b = moves_a ? other : moving;
  const double sign = moves_a ? 1 : -1;  // a - b
  const Vec2 d = direction_of(r, a, b), across = quarter_turned(d);
  std::vector<HalfPlane> out;
  // PUSH to contact begins before it.
  const double sooner = closes_gap(r) ? 0.5 * r.tolerance : 0;
  add_interval(d, sign, -extent(a.hull, -d) - extent(b.hull, d), r.lower - slack + sooner,
               r.upper + slack + sooner, out);
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

// Inside b's sides, as far as they are known.
std::vector<HalfPlane> edge_planes(const Relation& r, const Outline& moving, const Outline& other,
                                   bool moves_a, double slack) {
  const Outline &a = moves_a ? moving : other, &b = moves_a ? other : moving;
  std::vector<HalfPlane> out;
  for (const Side side : kAllSides) {
    const bool at = r.side == side;
    const Vec2 d = direction_of_side(b, side);
    // b's extent less a's grows as b goes along d.
    add_interval(d, moves_a ? -1 : 1, edge_gap(a, b, side), (at ? r.lower : 0) - slack,
                 at ? r.upper + slack : kInfinity, out);
  }
  return out;
}

Outline point_outline(const Vec2& p) {
  Outline out;
  out.hull = {p};
  out.centre = p;
  return out;
}

// The eye no farther from a than it reaches, seen from above.
std::vector<HalfPlane> reach_planes(const Relation& r, const Outline& moving, const Outline* other,
                                    bool moves_a, double slack) {
  if (!moves_a) return near_planes(r, point_outline(moving.centre), *other, slack);
  return near_planes(r, moving, point_outline(eye_of(r, other).head<2>()), slack);
}

// b's outline over a's, at least by a point.
std::vector<HalfPlane> under_planes(const Outline& moving, const Outline& other, double slack) {
  std::vector<HalfPlane> out;
  for (const Vec2& d : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
    add_interval(d, 1, -extent(moving.hull, -d) - extent(other.hull, d), -kInfinity, slack, out);
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
    case RelationKind::AtEdge:
      return edge_planes(r, moving, *other, moves_a, slack);
    case RelationKind::Under:
      return under_planes(moving, *other, slack);
    case RelationKind::Reach:
      return reach_planes(r, moving, other, moves_a, slack);
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

bool is_decided_by_planes(const Relation& r) {
  switch (r.kind) {
    case RelationKind::Against:
    case RelationKind::LeftOf:
    case RelationKind::RightOf:
    case RelationKind::InFrontOf:
    case RelationKind::Behind:
    case RelationKind::Centred:
    case RelationKind::Within:
    case RelationKind::At:
      return true;
    case RelationKind::AtEdge:
      return r.side.has_value();
    default:
      return false;
  }
}

bool closes_gap(const Relation& r) { return separates(r) && r.upper == 0; }

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
    case RelationKind::Perpendicular:
      step = 2;
      break;
    case RelationKind::Same:
      step = 4;
      break;
    default:
      return {};
  }
  std::vector<Rotation> out;
  const bool across = r.kind == RelationKind::Perpendicular;
  Vec2 wanted = across ? quarter_turned(other.front) : other.front;
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
