#include "ops/arrange/relations.h"

#include <algorithm>
#include <cmath>

#include "ops/arrange/relation_parts.h"

namespace trivet {
namespace {

constexpr double kMirroredDeg = 2;  // of a front against the mirror image of another

double outside(double value, double lower, double upper) {
  return std::max({0.0, lower - value, value - upper});
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

// At its side, or the nearest; inside all others.
double edge_cost(const Relation& r, const Outline& a, const Outline& b) {
  double least = kInfinity, gap = kInfinity;
  for (const Side side : kAllSides) {
    const double here = edge_gap(a, b, side);
    least = std::min(least, here);
    if (!r.side || *r.side == side) gap = std::min(gap, here);
  }
  return std::max(outside(gap, r.lower, r.upper), std::max(0.0, -least)) / r.tolerance;
}

}  // namespace

double near_distance(const Relation& r, const Outline& a, const Outline& b) {
  return distance(a.hull, b.hull, r.lower > 0 ? 0 : r.upper);
}

double near_cost(const Relation& r, double distance) {
  return outside(distance, r.lower, r.upper) / r.tolerance;
}

double relation_cost(const Relation& r, const Outline& a, const Outline* b) {
  switch (r.kind) {
    case RelationKind::On:
    case RelationKind::In:
    case RelationKind::Under:
    case RelationKind::View:
    case RelationKind::Reach:
      return 0;
    case RelationKind::Against:
    case RelationKind::LeftOf:
    case RelationKind::RightOf:
    case RelationKind::InFrontOf:
    case RelationKind::Behind:
      return beside_cost(r, a, *b);
    case RelationKind::AtEdge:
      return edge_cost(r, a, *b);
    case RelationKind::Near:
      return near_cost(r, near_distance(r, a, *b));
    case RelationKind::Facing:
    case RelationKind::Away:
      return angle_between_deg(a.front, wanted_front(r, a, b)) / r.tolerance;
    case RelationKind::Aligned:
      return turned_from(a.front, b->front, 90) / r.tolerance;
    case RelationKind::Parallel:
      return turned_from(a.front, b->front, 180) / r.tolerance;
    case RelationKind::Perpendicular:
      return turned_from(a.front, quarter_turned(b->front), 180) / r.tolerance;
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

}  // namespace trivet
