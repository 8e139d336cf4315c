// Private to gpu: the shaders of z-lists. README.md derives what they compute.
//
// A shader is put together from a version line, a model (how a face looks along a straight or along
// a turning motion) and a program that asks the model which pixels a face covers at which depths.
// All lengths are in pixels, also along a straight motion; along a turn, depth is the angle.
#pragma once

#include <cstdint>
#include <string>

#include "core/motion/motion.h"

namespace trivet::zlist_shaders {

/// What a pass does with what it sees in a pixel.
enum class Pass {
  Moving,       // gathers how far the moving faces reach
  Fixed,        // how near the fixed faces come, and by when something surely touches
  MovingLists,  // writes down the faces in doubtful pixels
  FixedLists,
};

/// GLSL without version: what the model needs to know, and `Cell look(Face, ivec2 pixel)`.
/// @param qualifier  "uniform", or nothing for variables.
std::string inputs(const char* qualifier);
std::string model(Motion::Kind kind);
std::string rotation_model();  // a part of it

/// OpenGL 4.3.
std::string compute(Motion::Kind kind, Pass pass);
std::string reduction();  // bounds, doubtful pixels

/// OpenGL 3.3. One quad per face, over the pixels that it may cover.
std::string face_vertex(Motion::Kind kind);
std::string quad_geometry(Motion::Kind kind);
std::string depth_fragment(Motion::Kind kind, Pass pass);
/// A point for each list entry, for transform feedback of `record`. A run of it looks at some
/// doubtful pixels; one that has more entries than it may write ends with pixel kTooMany.
std::string list_geometry(Motion::Kind kind, Pass pass);

inline constexpr int kRecordsPerRun = 128;
inline constexpr int kManyPixelsPerRun = 512;                    // fast
inline constexpr int kFewPixelsPerRun = kRecordsPerRun / 2 - 2;  // never too many
inline constexpr std::uint32_t kTooMany = 0xffffffffu;

}  // namespace trivet::zlist_shaders
