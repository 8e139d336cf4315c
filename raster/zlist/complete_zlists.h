// Complete z-lists of static bodies: per pixel, every face on its lines of sight.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/contact/body.h"
#include "raster/zlist/projection.h"

namespace trivet {

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
