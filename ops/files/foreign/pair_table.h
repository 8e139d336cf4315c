// Rules for pairs of bodies, from the bits and friction of their colliders. Private.
#pragma once

#include "core/io/foreign/scene.h"
#include "core/scene/scene.h"

namespace trivet {

/// Kinds of bodies and of the floor, and the rules between them.
struct PairTable {
  std::vector<PairKind> kinds;  // by body
  PairKind floor_kind = 0;
  std::shared_ptr<const PairRules> rules;
};

/// @param floor  the colliding plane that is the scene's floor; null: there is none.
PairTable pair_table(const ForeignScene& scene, const ForeignCollider* floor);

/// Whether two colliders meet, by their bits.
bool collide(const ContactBits& a, const ContactBits& b);
double pair_friction(const ContactBits& a, const ContactBits& b, FrictionRule rule);

}  // namespace trivet
