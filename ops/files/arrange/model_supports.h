// Stable poses and support surfaces of a model, for `trivet info`.
#pragma once

#include <string>

#include "core/index/shape.h"
#include "core/model/model.h"

namespace trivet {

/// Sections of `trivet info` that are asked for.
struct ModelSupports {
  bool poses = false, surfaces = false;
};

/// model_info_json() with "poses", "upright" (index of a pose, or null and "upright_reason") and
/// "surfaces" in it, and in the 24 likeliest poses "settled": where PUT lets them rest; lengths in
/// the file's units, as the model stands by its own up.
std::string model_info_json(const Model& model, const Shape& shape, const ModelSupports& asked);
/// For people: model_info_text() and tables.
std::string model_info_text(const Model& model, const Shape& shape, const ModelSupports& asked);

}  // namespace trivet
