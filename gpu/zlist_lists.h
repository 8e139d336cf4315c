// Private to gpu: what a view of the moving and the fixed faces is, and the lists that come of it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/contact/zlist_stage.h"
#include "gpu/zlist_mesh_cache.h"
#include "gpu/zlist_structs.h"

namespace trivet {

/// A body as the image sees it. README.md says what blur holds.
struct ZListBody {
  const GpuMesh* mesh = nullptr;
  Index body = 0;                // in the query's span
  std::uint32_t first_face = 0;  // number of its first face among all of the view
  std::array<float, 12> rows{};  // pixels from object, row by row; the object about its centre
  float blur = 0, depth_blur = 0;
};

/// All that a rasteriser needs. Lengths in pixels, also depths along a straight motion; depths of a
/// turn are angles.
struct ZListView {
  Motion::Kind kind = Motion::Kind::Translation;
  int width = 0, height = 0;
  float first_radius = 0;
  float period = 0;       // of depth: a whole turn, or 0
  float first_depth = 0;  // angles are counted from there
  float sample_error = 0;
  float horizon = 0;  // later does not matter
  std::vector<ZListBody> moving, fixed;
};

using ZListEntry = glsl::Entry;

/// Complete lists of the doubtful pixels, in no order; times are depths, see ZListView.
struct ZLists {
  bool overflow = false;  // more entries than there is room for: nothing else means anything
  float upper = 0;        // samples meet by then; the horizon where none do
  float lower = 0;        // nothing meets before
  std::int64_t num_pixels = 0, num_doubtful = 0, bytes_read_back = 0;
  std::vector<ZListEntry> entries;
};

/// A way of using the hardware. All need a current context, to live and to die.
class ZListRaster {
 public:
  virtual ~ZListRaster() = default;
  virtual const char* method() const = 0;     // for people
  virtual std::size_t num_bytes() const = 0;  // of graphics memory, meshes apart
  /// Whether there is room for this many views, the largest of that many pixels.
  virtual bool has_room(std::size_t num_views, std::size_t num_pixels) const = 0;
  /// Draws views of one kind of motion together; when the lists of all are too long, none has any.
  /// @param bounds_alone  nobody wants lists.
  /// @throws Error (Environment) when OpenGL fails.
  virtual std::vector<ZLists> rasterise(std::span<const ZListView> views, bool bounds_alone) = 0;
};

/// OpenGL 4.3: compute shaders. @param max_entries  of the lists of all views of a batch.
std::unique_ptr<ZListRaster> make_compute_raster(std::uint32_t max_entries);
/// OpenGL 3.3: framebuffers that blend maxima, transform feedback.
/// @param resolution  of the largest view, both ways. @param max_entries  of moving, or fixed,
/// faces.
std::unique_ptr<ZListRaster> make_blend_raster(int resolution, std::uint32_t max_entries);

}  // namespace trivet
