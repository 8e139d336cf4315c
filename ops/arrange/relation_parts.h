// Private. Parts of relations that their costs and their half planes share.
#pragma once

#include "ops/arrange/relations.h"

namespace trivet {

/// Outwards from a side of b.
Vec2 direction_of_side(const Outline& b, Side side);
/// From b, in which a lies; of Against: towards which a's side looks, turned round.
Vec2 direction_of(const Relation& r, const Outline& a, const Outline& b);
/// Metres along which they are beside each other: of the narrower one, or of the side that is
/// against something.
double wanted_overlap(const Relation& r, const Outline& a, const Outline& b, const Vec2& across);
/// From a side of b to a's outline, inwards.
double edge_gap(const Outline& a, const Outline& b, Side side);
/// From where a is seen and reached: the relation's point, or over b's centre.
Vec3 eye_of(const Relation& r, const Outline* b);
Vec2 mirrored_direction(const Relation& r, const Vec2& v);
Vec2 mirrored_point(const Relation& r, const Vec2& p);

inline constexpr Side kAllSides[] = {Side::Front, Side::Back, Side::Left, Side::Right};

}  // namespace trivet
