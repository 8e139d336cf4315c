// Private. Physics materials as JSON: in layouts, operations and scene files.
#pragma once

#include "core/scene/physics_material.h"
#include "ops/files/json/text.h"

namespace trivet {

/// A preset's name, or {"friction", "density", "restitution"} of which what is missing has its
/// default.
/// @throws Error (BadInput) with the place, the value and what is accepted.
PhysicsMaterial read_material(const JsonPlace& place);

/// Writes the material so that read_material() reads it to the same bits.
nlohmann::ordered_json material_json(const PhysicsMaterial& material);

/// All of it: {"name": of a preset or null, "friction", "density", "restitution"}.
nlohmann::ordered_json whole_material_json(const PhysicsMaterial& material);

/// Adds what is not the default.
void write_material(const char* key, const PhysicsMaterial& material, nlohmann::ordered_json& json);

}  // namespace trivet
