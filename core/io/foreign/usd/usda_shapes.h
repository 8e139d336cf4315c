// Colliding shapes of USD.
#pragma once

#include <functional>
#include <optional>

#include "core/io/foreign/scene.h"
#include "core/io/foreign/usd/usda_frames.h"

namespace trivet {

/// A number of a prim's property; nothing: it has none, or infinity, which says so.
std::optional<double> usda_number(const UsdaPrim& prim, std::string_view property);
std::optional<Vec3> usda_vector(const UsdaPrim& prim, std::string_view property);
std::optional<Rotation> usda_turn(const UsdaPrim& prim, std::string_view property);
/// The first word of a property or an entry of metadata; "" for null.
std::string usda_word(const UsdaEntry* entry);
bool usda_flag(const UsdaPrim& prim, std::string_view property, bool otherwise);

/// True if prims of the type can collide.
bool is_usda_shape(const std::string& type);

/// The shape of a prim in its body's frame: mesh and where it stands; a plane has no mesh.
/// @param in_body  of the prim. @param unread  gets why there is none.
std::optional<ForeignCollider> usda_collider(const UsdaPrim& prim, const UsdaFrame& in_body,
                                             bool true_meshes, std::vector<Sentence>& unread);

}  // namespace trivet
