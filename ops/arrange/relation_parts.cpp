#include "ops/arrange/relation_parts.h"

#include <algorithm>

namespace trivet {

Vec2 direction_of_side(const Outline& b, Side side) {
  switch (side) {
    case Side::Front:
      return b.front;
    case Side::Back:
      return -b.front;
    case Side::Left:
      return -b.right();
    case Side::Right:
      break;
  }
  return b.right();
}

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
  switch (r.side.value_or(Side::Back)) {  // of a, which is turned to b
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

double wanted_overlap(const Relation& r, const Outline& a, const Outline& b, const Vec2& across) {
  const double width = a.width(across);
  return r.overlap * (r.kind == RelationKind::Against ? width : std::min(width, b.width(across)));
}

double edge_gap(const Outline& a, const Outline& b, Side side) {
  const Vec2 d = direction_of_side(b, side);
  return extent(b.hull, d) - extent(a.hull, d);
}

Vec3 eye_of(const Relation& r, const Outline* b) {
  if (r.eye) return *r.eye;
  return {b->centre.x(), b->centre.y(), b->bottom + r.eye_height};
}

Vec2 mirrored_direction(const Relation& r, const Vec2& v) { return 2 * v.dot(r.axis) * r.axis - v; }

Vec2 mirrored_point(const Relation& r, const Vec2& p) {
  return *r.point + mirrored_direction(r, p - *r.point);
}

}  // namespace trivet
