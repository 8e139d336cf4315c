// Rules for pairs of bodies, from the bits and friction of their colliders. Private.
#pragma once

#include "core/io/foreign/scene.h"
#include "ops/files/foreign/judged_scene.h"

namespace trivet {

/// @param floor  the colliding plane that is the scene's floor; null: there is none.
/// @param links_move  fixed bodies meet, but for links and what they hang in; else they pass.
PairTable pair_table(const ForeignScene& scene, const ForeignCollider* floor, bool links_move);

/// True if two colliders meet, by their bits.
bool collide(const ContactBits& a, const ContactBits& b);
double pair_friction(const ContactBits& a, const ContactBits& b, FrictionRule rule);

}  // namespace trivet
