// Private. Marks for the section "arrange" beside a layout's objects: "front", "zones" and
// "surfaces".
#pragma once

#include "ops/files/json/text.h"

namespace trivet {

/// Refuses marks of an object where no section can take them.
void refuse_marks(const JsonPlace& object);

/// The section "arrange" of a layout, with the fronts, zones and surfaces of its objects in it.
/// @param root  the layout, with the section and "objects".
/// @throws Error (BadInput) for a section that is no object, for what is no front, zone or surface,
/// and for
///   a front that an object has in both places.
nlohmann::json section_with_marks(const JsonPlace& root);

}  // namespace trivet
