// Private. One operation as JSON: for layouts, journals and sessions.
#pragma once

#include "ops/files/json/json_text.h"
#include "ops/operations/operations.h"

namespace trivet {

/// Reads strictly what layout.schema.json says of an operation. Whether there is such an object is
/// for the caller to see.
/// @throws Error (BadInput) with the place, the value and what is accepted.
Operation read_operation(const JsonPlace& place);

/// JSON that read_operation() reads to the same bits; defaults are left out.
nlohmann::ordered_json operation_json(const Operation& operation);

/// "y" or "z".
UpAxis read_up(const JsonPlace& place);

/// "chord" and "facet_angle_deg" of a model; refused for formats of triangles.
Tessellation read_tessellation(const JsonPlace& place, const std::string& model);
/// Values that are not the default.
void write_tessellation(const Tessellation& tessellation, nlohmann::ordered_json& json);

/// "position" and "rotation" (optional, the identity) of an object. See unit_rotation().
Pose read_pose(const JsonPlace& place);
void write_pose(const Pose& pose, nlohmann::ordered_json& json);

}  // namespace trivet
