// Images and texture coordinates of models for simulators. Private.
#pragma once

#include <memory>

#include "core/io/simulators/simulation_look.h"

namespace trivet {

/// Null: no material has an image of its base colour. Made once while the model lives.
/// Thread-safe. @throws Error (Environment) with libpng's reason.
std::shared_ptr<const SimulationLook> simulation_look(const std::shared_ptr<const Model>& model);

}  // namespace trivet
