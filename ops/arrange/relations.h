// Relations between outlines: how well they hold, and where an object has to be for that.
#pragma once

#include <vector>

#include "ops/arrange/arrangement.h"
#include "ops/arrange/convex_region.h"
#include "ops/arrange/outline.h"

namespace trivet {

/// Cost in tolerances: 0 where it holds exactly, 1 at its tolerance. Relations of support and of
/// sight are not seen from above: 0.
/// @param b  null where the relation has none.
double relation_cost(const Relation& relation, const Outline& a, const Outline* b);

/// Half planes of the position of one of both in which the relation can hold to half its tolerance;
/// those of a convex region exactly, others contain it. None: nothing is known.
/// @param moving  at position zero. @param other  where it stands; null where there is none.
/// @param moves_a  `moving` is the relation's a, else its b.
/// @param more  metres by which all of them are wider.
std::vector<HalfPlane> half_planes(const Relation& relation, const Outline& moving,
                                   const Outline* other, bool moves_a, double more = 0);

/// True of a relation that holds wherever the position is in all of its half planes.
bool is_decided_by_planes(const Relation& relation);

/// True of a relation that keeps the outlines of its objects apart.
bool separates(const Relation& relation);
/// True of one of these whose gap is to be 0: a is pushed to b where it came to rest.
bool closes_gap(const Relation& relation);
/// The gap between the outlines of both; of none: 0 and more.
relations::Gap gap_of(const Relation& relation);
/// True of a relation that asks for a distance of the outlines, at least.
bool has_least_distance(const Relation& relation);

/// From b, in which a lies, for a relation that says so.
Vec2 direction_of(const Relation& relation, const Outline& a, const Outline& b);

/// Turns about z that bring the front of a, or of b, to where a relation of directions asks for it;
/// none: the relation does not say. @param other  of the two, the one that stands.
std::vector<Rotation> turns_asked_for(const Relation& relation, const Outline& moving,
                                      const Outline& other);
/// True of one that asks for none of b.
bool turns_only_a(const Relation& relation);

/// Direction from a to what it faces, or from which it looks away; zero: the relation is another.
Vec2 wanted_front(const Relation& relation, const Outline& a, const Outline* b);

}  // namespace trivet
