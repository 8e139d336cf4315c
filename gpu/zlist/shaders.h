// Private to gpu: the shaders of z-lists. README.md derives them.
//
// A shader consists of a version line, a model (how a face appears along a translation or a
// rotation) and a program that asks the model for the pixels of a face and its depths there. All
// lengths are in pixels, also along a translation; along a rotation, depth is the angle.
#pragma once

#include <cstdint>
#include <string>

#include "core/motion/motion.h"

namespace trivet::zlist_shaders {

/// Action of a pass on the faces in a pixel.
enum class Pass {
  Moving,       // gathers the extent of the moving faces
  Fixed,        // gathers the nearest fixed faces, and an upper bound of the contact
  MovingLists,  // records the faces in doubtful pixels
  FixedLists,
};

/// GLSL without version: the model's parameters, and `Cell look(Face, ivec2 pixel)`.
/// @param qualifier  "uniform", or empty for variables.
std::string inputs(const char* qualifier);
std::string model(Motion::Kind kind);
std::string rotation_model();  // a part of it

/// Where shaders find the depths of the pixels.
enum class Depths { Storage, Framebuffers };

/// OpenGL 4.3. Passes Moving and Fixed need storage.
std::string compute(Motion::Kind kind, Pass pass, Depths depths);
std::string upper_bounds();            // from the pixels of framebuffers
std::string reduction(Depths depths);  // bounds, doubtful pixels

/// OpenGL 3.3: framebuffers that blend maxima, so minima are negated. Moving: front, -rear, sample.
/// Fixed: -nearest, -bound of the time. One quad per face, over the pixels it may cover.
std::string face_vertex(Motion::Kind kind);
std::string quad_geometry(Motion::Kind kind);
std::string depth_fragment(Motion::Kind kind, Pass pass);
std::string empty_texels();  // kNone, is_none()

/// OpenGL 3.3, for one view of a batch.
std::string list_vertex(Motion::Kind kind);
/// Emits a point for each list entry, for transform feedback of `record`. A run processes some
/// doubtful pixels; if it exceeds its entry limit, it ends with pixel kTooMany.
std::string list_geometry(Motion::Kind kind, Pass pass);

inline constexpr int kRecordsPerRun = 128;
inline constexpr int kManyPixelsPerRun = 512;                    // fast
inline constexpr int kFewPixelsPerRun = kRecordsPerRun / 2 - 2;  // never too many
inline constexpr std::uint32_t kTooMany = 0xffffffffu;

}  // namespace trivet::zlist_shaders
