// Physics materials by name, and what a material may be.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/scene/physics_material.h"

namespace trivet {

/// Materials of everyday things, dry and clean. A coefficient belongs to a pair of surfaces; these
/// are of a surface against its own kind or, where the source has only that, against wood or
/// concrete. Static coefficients where they are safe to count on, else the sliding one. Sources:
/// materials.cpp. Sorted by name. Scenes and layouts keep the name alone: a better value gets a new
/// name.
std::span<const PhysicsMaterial> material_presets();
std::vector<std::string> material_names();
/// @return nullopt if there is no such preset.
std::optional<PhysicsMaterial> material_preset(const std::string& name);

/// Metres that an open sheet of this preset is usually thick: tableware, panes, boards, sheets.
/// Estimates of everyday things, by which open meshes weigh; values: materials.cpp. nullopt for
/// numbers without a name.
std::optional<double> sheet_thickness(const PhysicsMaterial& material);

/// True if numbers and name are the same.
bool same_material(const PhysicsMaterial& a, const PhysicsMaterial& b);
/// True if it is the preset of its name; false without a name.
bool is_preset(const PhysicsMaterial& material);

}  // namespace trivet
