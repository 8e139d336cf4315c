// Arrays of records in NumPy's format.
#pragma once

#include <string>
#include <vector>

#include "ops/files/report/json_parts.h"

namespace trivet {

/// Rows as a one-dimensional array with a field for each key: booleans, texts and else float64, in
/// which null is NaN. Version 1.0 of the format, little-endian.
/// @param rows  objects with these keys. @param keys  of ASCII.
std::string npy_records(const std::vector<std::string>& keys, const std::vector<OrderedJson>& rows);

}  // namespace trivet
