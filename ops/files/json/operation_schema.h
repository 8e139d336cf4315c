// Private. The part of the schema of layouts that says what operations accept, by their tables.
#pragma once

#include <nlohmann/json.hpp>

namespace trivet {

/// Alternatives of one operation, for "oneOf". Refers to definitions of layout.schema.in.json:
/// new_name, name_of_object, support, text, point, point_2d, rotation, material.
nlohmann::ordered_json operation_schemas();

/// layout.schema.in.json with them. @param base  its text.
nlohmann::ordered_json layout_schema(const char* base);

}  // namespace trivet
