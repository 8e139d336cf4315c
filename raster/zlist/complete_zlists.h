// Complete z-lists of static bodies: per pixel, every face on its lines of sight.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/contact/body.h"

namespace trivet {

/// A rectangle of the image, metres along Projection::right and Projection::up from the world's
/// origin.
struct ImageRegion {
  Vec2 lower, upper;
};

struct ProjectionOptions {
  Vec3 direction = -Vec3::UnitZ();                // of sight, away from the eye; any length but 0
  int resolution = 256;                           // pixels along the longer side, 1 to 8192
  std::optional<ImageRegion> region;              // nullopt: everything the bodies cover
  std::size_t most_bytes = std::size_t{1} << 30;  // of the lists
  int num_threads = 1;                            // 0: all cores; results do not depend on it
};

/// Placement of pixels. Orthogonal; pixel (i, j), j from the bottom, is the square starting at
/// corner + pixel (i, j).
struct Projection {
  Vec3 right, up, direction;   // unit; up is as close to the world's z as possible, else its y
  Vec2 corner = Vec2::Zero();  // metres, as of ImageRegion
  double nearest = 0;          // depth of ZListItem 0, metres
  double pixel = 0;            // metres
  int width = 0, height = 0;

  /// Distance along `direction` from the plane through the world's origin; metres.
  double depth(float of_item) const { return nearest + pixel * of_item; }
};

/// A face in a pixel. Depths in pixels from Projection::nearest.
struct ZListItem {
  std::uint32_t body, face;  // index into the span; triangle of its mesh
  float lower, upper;        // contain all depths of the face within the pixel
  float centre;              // on the line through the pixel's centre; NaN: possibly missed
};

/// Event of a line of sight at a face.
enum class Crossing {
  Unknown,  // the mesh is not a solid: it has no inside
  Enters,
  Leaves,
  Along,  // the face is seen edge-on
};
const char* to_string(Crossing crossing);  // "unknown", "enters", ...

/// [Shinya 1995, section 2], departing in that lists are conservative: a face is in the list of
/// every pixel that it touches (or misses by less than 0.02 pixels), with an interval of depths
/// instead of one. Lists are sorted by (lower, upper, body, face).
class CompleteZLists {
 public:
  /// Cost O(faces + entries log(longest list)). Counts before it stores.
  /// @throws Error (BadInput) for options out of range, and if the lists would be larger than
  ///   `most_bytes`: the message names all numbers.
  CompleteZLists(std::span<const Body> bodies, const ProjectionOptions& options);

  const Projection& projection() const { return m_projection; }
  /// Nearest first. @param row  from the bottom.
  std::span<const ZListItem> list(int column, int row) const;
  /// Unknown unless the mesh is a solid.
  Crossing crossing(const ZListItem& item) const;

  std::size_t num_entries() const { return m_items.size(); }
  std::size_t num_bytes() const;
  std::size_t num_covered() const;  // pixels with a list
  std::size_t longest() const;      // entries of the longest list

 private:
  void draw(std::size_t most_bytes, int num_threads);
  std::string size_text() const;

  std::span<const Body> m_bodies;  // not owned
  Projection m_projection;
  std::vector<std::uint64_t> m_ends;  // of each pixel's items
  std::vector<ZListItem> m_items;
  std::vector<signed char> m_winding;  // of each body: 1 outward, -1 inside out, 0 not a solid
};

}  // namespace trivet
