// Cloths, papers and cables by name.
#pragma once

#include <optional>
#include <span>

#include "core/flex/material.h"

namespace trivet::flex {

struct FlexPreset {
  FlexMaterial material;
  bool is_cable = false;
  float colour[3];  // linear RGB
};

/// Sorted by name; sources: presets.cpp.
std::span<const FlexPreset> flex_presets();
/// @return nullptr if there is none.
const FlexPreset* flex_preset(const std::string& name);

}  // namespace trivet::flex
