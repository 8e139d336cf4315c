// A model that no file has, as JSON in a scene file: to the bit, arrays as base64.
//
//   {"vertices": float64, 3 each, "triangles": int32, 3 each,
//    and of a model that no node of the scene shows:
//    "materials": [{"name", "base_colour", "metallic", "roughness"}],
//    "face_material": int32, "corner_normals": float32, 9 each}        if there are any
#pragma once

#include "core/model/model.h"
#include "ops/files/json/text.h"
#include "ops/files/report/json_parts.h"

namespace trivet {

/// @param whole  with materials and normals.
OrderedJson stored_mesh_json(const Model& model, bool whole);

/// Without path and format. @throws Error (BadInput) naming the place: arrays that do not fit each
///   other, coordinates that are not finite, ids out of range.
Model read_stored_mesh(const JsonPlace& place);

}  // namespace trivet
