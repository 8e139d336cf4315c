// Colours of models that have none, so that objects are told apart.
#pragma once

#include <memory>
#include <string_view>

#include "core/io/textures/surface_look.h"

namespace trivet {

/// Colour for a name, linear RGB: one of 72, of even lightness and little chroma. The same on every
/// run.
/// @see [Ottosson 2020] for the space that it is even in.
std::array<float, 3> quiet_colour(std::string_view name);

/// A single material in the colour of the model's file name (without one: of its geometry), if the
/// file gives it no colour: all its materials are what the importer takes where a file has none.
/// The look has no finishes. @return null: the file gives colours.
std::shared_ptr<const SurfaceLook> quiet_look(const Model& model);

}  // namespace trivet
