// Private. One operation as JSON, by its table: for layouts, journals and sessions.
#pragma once

#include "ops/files/json/values.h"
#include "ops/operations/operations.h"
#include "ops/operations/table.h"

namespace trivet {

/// Reads strictly what the schema of layouts says of an operation (operation_schema.h). Whether
/// there is such an object is for the caller to see.
/// @throws Error (BadInput) with the place, the value and what is accepted.
Operation read_operation(const JsonPlace& place);

/// JSON that read_operation() reads to the same bits; defaults are left out.
nlohmann::ordered_json operation_json(const Operation& operation);

/// One argument as JSON; null: none. @param slot  of this field.
nlohmann::ordered_json value_json(const Field& field, const Slot& slot);

}  // namespace trivet
