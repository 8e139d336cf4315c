// Private. One operation as JSON: for layouts, journals and sessions.
#pragma once

#include "ops/files/json/values.h"
#include "ops/operations/operations.h"

namespace trivet {

/// Reads strictly what layout.schema.json says of an operation. Whether there is such an object is
/// for the caller to see.
/// @throws Error (BadInput) with the place, the value and what is accepted.
Operation read_operation(const JsonPlace& place);

/// JSON that read_operation() reads to the same bits; defaults are left out.
nlohmann::ordered_json operation_json(const Operation& operation);

/// Inverse of read_tessellation(): values that are not the default.
void write_tessellation(const Tessellation& tessellation, nlohmann::ordered_json& json);
/// Inverse of read_pose().
void write_pose(const Pose& pose, nlohmann::ordered_json& json);

}  // namespace trivet
