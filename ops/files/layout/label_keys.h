// Private. What labelled images are told of an object: "class" and "attributes".
#pragma once

#include "ops/files/json/text.h"
#include "ops/files/layout/layout.h"

namespace trivet {

/// Reads the two keys, as far as they are there, into the object.
/// @throws Error (BadInput) with the place, the value and what is accepted.
void read_labels(const JsonPlace& place, LayoutObject& object);

}  // namespace trivet
