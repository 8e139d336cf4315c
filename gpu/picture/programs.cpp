#include "gpu/picture/programs.h"

#include "gpu/picture/shaders.h"

namespace trivet {

using picture_shaders::Surfaces;

PicturePrograms::PicturePrograms(bool emits)
    : surface("surfaces", picture_shaders::surface_vertex(Surfaces::Plain),
              picture_shaders::surface_fragment(false, Surfaces::Plain)),
      surface_see_through("see-through surfaces", picture_shaders::surface_vertex(Surfaces::Plain),
                          picture_shaders::surface_fragment(true, Surfaces::Plain)),
      shadow("shadows", picture_shaders::shadow_vertex(), picture_shaders::shadow_fragment(false)),
      shadow_see_through("see-through shadows", picture_shaders::shadow_vertex(),
                         picture_shaders::shadow_fragment(true)),
      floor_light("floor light", picture_shaders::whole_target_vertex(),
                  picture_shaders::floor_light_fragment()),
      light("light", picture_shaders::whole_target_vertex(),
            picture_shaders::light_fragment(emits)),
      develop("development", picture_shaders::whole_target_vertex(),
              picture_shaders::develop_fragment()) {}

TexturedPrograms::TexturedPrograms()
    : surface("textured surfaces", picture_shaders::surface_vertex(Surfaces::Textured),
              picture_shaders::surface_fragment(false, Surfaces::Textured)),
      surface_see_through("textured see-through surfaces",
                          picture_shaders::surface_vertex(Surfaces::Textured),
                          picture_shaders::surface_fragment(true, Surfaces::Textured)),
      shadow_see_through("textured see-through shadows",
                         picture_shaders::shadow_vertex(Surfaces::Textured),
                         picture_shaders::shadow_fragment(true, Surfaces::Textured)) {}

}  // namespace trivet
