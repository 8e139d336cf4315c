// Cloths and cables at rest as JSON: for people, and whole for scene files.
//
//   flexible_json()         {"material", "vertices": number, "net_force", "net_force_at",
//                            "friction_used", "balance", "stretch", "stable", "steps", "contacts",
//                            "own_contacts", "supports": [{"name", "share"}]}
//   stored_flexible_json()  {"cable": true or false, "material": {"name", "density", "thickness",
//                            "stretch", "coupling", "shear", "bending", "twist", "friction"},
//                            "vertices", "faces", "forces", "layer", "pressure", "rest": the first,
//                            of a sheet "grid": [cells, cells, metres, metres], of a cable
//                            "length", of a mesh "rest_vertices"; "pins": ids of vertices} arrays
//                            as base64: float64, of faces int32
#pragma once

#include "core/flex/flexible.h"
#include "ops/files/json/text.h"
#include "ops/files/report/json_parts.h"

namespace trivet {

OrderedJson flexible_json(const Flexible& flexible);
OrderedJson stored_flexible_json(const Flexible& flexible);

/// @throws Error (BadInput) naming the place: arrays that do not fit each other, numbers that are
///   not finite, ids out of range.
Flexible read_stored_flexible(const JsonPlace& place);

}  // namespace trivet
