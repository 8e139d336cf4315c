// Unit of models' files.
#pragma once

#include <optional>

#include "core/model/model.h"

namespace trivet {

/// Metres per unit of a model's file: as given, else as the file states, else 1.
/// @param model  null: of shapes made in memory.
inline double metres_per_unit(std::optional<double> given, const Model* model) {
  if (given) return *given;
  return model && model->metres_per_unit ? *model->metres_per_unit : 1.0;
}

}  // namespace trivet
