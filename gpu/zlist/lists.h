// Private to gpu: a view of the moving and the fixed faces, and the resulting lists.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/candidates/zlist_stage.h"
#include "gpu/zlist/mesh_cache.h"
#include "gpu/zlist/structs.h"

namespace trivet {

/// A body as placed in the image. README.md defines blur.
struct ZListBody {
  const GpuMesh* mesh = nullptr;
  Index body = 0;                // in the query's span
  std::uint32_t first_face = 0;  // number of its first face among all of the view
  std::array<float, 12> rows{};  // pixels from object, row by row; object relative to its centre
  float blur = 0, depth_blur = 0;
};

/// Complete input of a rasteriser. Lengths in pixels, also depths along a translation; depths of a
/// rotation are angles.
struct ZListView {
  Motion::Kind kind = Motion::Kind::Translation;
  int width = 0, height = 0;
  float first_radius = 0;
  float period = 0;       // of depth: a whole turn, or 0
  float first_depth = 0;  // origin of angles
  float sample_error = 0;
  float horizon = 0;  // later times are irrelevant
  /// So many doubtful pixels, or fewer, are handed over, for lists in software; of more, lists are
  /// made. 0: always made.
  std::uint32_t most_handed_over = 0;
  std::vector<ZListBody> moving, fixed;
};

using ZListEntry = glsl::Entry;

/// The doubtful pixels themselves, or complete lists of them, unordered; times are depths, see
/// ZListView.
struct ZLists {
  bool overflow = false;     // more entries than fit: the other fields are meaningless
  bool handed_over = false;  // entries are the doubtful pixels, without depths and face
  float upper = 0;           // two samples meet by then; the horizon if none do
  float lower = 0;           // no contact before this
  std::int64_t num_pixels = 0, num_doubtful = 0;
  std::int64_t bytes_read_back = 0, read_backs = 0;  // of a batch: in its first view
  std::vector<ZListEntry> entries;
};

/// Output of a rasteriser. Bounds: without entries.
enum class ZListOutput { Bounds, Lists };

/// For ZListView::most_handed_over: lists are never made.
inline constexpr std::uint32_t kAllHandedOver = 0xffffffffu;

/// A way of using the hardware. All need a current context to be created and destroyed.
class ZListRaster {
 public:
  virtual ~ZListRaster() = default;
  virtual const char* description() const = 0;  // for display
  virtual std::size_t num_bytes() const = 0;    // of graphics memory, without meshes
  /// True if this many views with that many bodies fit, the widest and the highest of that size.
  virtual bool has_room(std::size_t num_views, std::size_t num_bodies, int width,
                        int height) const = 0;
  /// True if lists in many small pixels take long.
  virtual bool prefers_large_pixels() const { return false; }
  /// Draws views of one kind of motion together; if the lists exceed the limit together, all are
  /// empty.
  /// @throws Error (Environment) when OpenGL fails.
  virtual std::vector<ZLists> rasterise(std::span<const ZListView> views, ZListOutput output) = 0;
};

/// The most pixels of all layers together.
inline constexpr std::size_t kMaxZListPixels = 1 << 20;

/// OpenGL 4.3: compute shaders. @param max_entries  of the lists of all views of a batch.
std::unique_ptr<ZListRaster> make_compute_raster(std::uint32_t max_entries);
/// OpenGL 4.3: depths by framebuffers that blend maxima, then as above.
std::unique_ptr<ZListRaster> make_framebuffer_raster(std::uint32_t max_entries);
/// OpenGL 3.3: the same framebuffers, lists by transform feedback.
/// @param max_entries  of the moving, or fixed, faces of a view.
std::unique_ptr<ZListRaster> make_feedback_raster(std::uint32_t max_entries);

}  // namespace trivet
