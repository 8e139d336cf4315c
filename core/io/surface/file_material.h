// Materials of files with the textures that they name.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/model/model.h"

namespace trivet {

/// A texture as a material names it.
struct FileTexture {
  std::string name;    // of its file
  std::string folder;  // of the file that names it, relative to the model's; empty: the same
  bool clamps = false;
  std::array<float, 2> scale{1, 1}, offset{0, 0};  // of coordinates; v runs up
};

struct FileMaterial {
  Material surface;
  std::array<float, 3> emission{};  // linear
  bool cut_by_texture = false;      // its transparency is in a texture
  std::optional<FileTexture> base_colour, normal, emissive;
  std::vector<FileTexture> unread;  // of kinds that are left out
};

}  // namespace trivet
