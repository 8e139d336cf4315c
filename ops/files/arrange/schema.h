// Private. The schema of arrangements: kinds of relations say by their fields what they accept.
#pragma once

#include <nlohmann/json.hpp>

namespace trivet {

/// Alternatives of one relation, for "oneOf"; kinds that accept the same share one. They refer to
/// definitions of arrange.schema.in.json: text, level, point, gap, tolerance, weight.
nlohmann::ordered_json relation_schemas();

/// arrange.schema.in.json with them before its patterns. @param base  its text.
nlohmann::ordered_json arrange_schema(const char* base);

}  // namespace trivet
