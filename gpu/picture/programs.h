// Private to gpu: the shaders of pictures.
#pragma once

#include "gpu/egl/gl_objects.h"

namespace trivet {

struct PicturePrograms {
  /// @param emits  whether surfaces give light.
  explicit PicturePrograms(bool emits);
  GlProgram surface, surface_see_through, shadow, shadow_see_through, floor_light, light, develop;
};

/// Programs of textured meshes.
struct TexturedPrograms {
  TexturedPrograms();
  GlProgram surface, surface_see_through, shadow_see_through;
};

}  // namespace trivet
