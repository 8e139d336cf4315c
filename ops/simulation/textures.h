// Textures of models as files for simulators take them: PNG images of base colours.
#pragma once

#include "core/io/simulators/simulation_scene.h"

namespace trivet {

/// Gives the model the base colour textures of its appearance, and the materials that use them.
/// Models without such textures stay as they are. Coordinates have the textures' own transforms in
/// them.   Cost: all images are decoded and encoded.
/// @param notes  receives what the model shows beyond that, and simulators do not.
void add_textures(SimulationModel& model, std::vector<Sentence>& notes);

}  // namespace trivet
