// Private to gpu: what the shaders of z-lists read and write, as C++ and as GLSL.
#pragma once

#include <cstddef>

#include "gpu/egl/shader_struct.h"

namespace trivet::glsl {

/// A body in a view. rows: pixels from object. layer: of the view.
TRIVET_SHADER_STRUCT(Instance, vec4 rows[3]; float blur, depth_blur; uint first_face, layer;);
static_assert(offsetof(Instance, blur) == 48 && sizeof(Instance) == 64);

/// A view. upper, lower: ordered depths. low_x to high_y: of the doubtful pixels, of which at most
/// most_handed_over go to software. Four texels, like an instance: framebuffers read both as
/// textures.
TRIVET_SHADER_STRUCT(Layer, ivec2 size; float first_radius, sample_error, period, first_depth;
                     uint upper, lower; uint num_pixels, num_doubtful;
                     uint low_x, low_y, high_x, high_y, most_handed_over, unused;);
static_assert(offsetof(Layer, first_radius) == 8 && offsetof(Layer, upper) == 24);
static_assert(offsetof(Layer, low_x) == 40 && sizeof(Layer) == 64);

/// large_groups: of the second dispatch.
TRIVET_SHADER_STRUCT(Counters, uint num_entries, num_large; uint large_groups[3];);
static_assert(offsetof(Counters, num_large) == 4 && offsetof(Counters, large_groups) == 8);
static_assert(sizeof(Counters) == 20);

/// A face in a pixel, and the depths that it has there at most. Faces are numbered over all bodies;
/// kNoFace: the pixel is handed over.
TRIVET_SHADER_STRUCT(Entry, uint pixel; float low, high; uint face;);
static_assert(offsetof(Entry, low) == 4 && offsetof(Entry, face) == 12 && sizeof(Entry) == 16);
inline constexpr unsigned kNoFace = 0xffffffffu;

}  // namespace trivet::glsl
