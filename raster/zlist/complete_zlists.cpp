#include "raster/zlist/complete_zlists.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <tuple>

#include "core/base/bad_input.h"
#include "core/base/parallel.h"
#include "raster/zlist/depth_map.h"

namespace trivet {
namespace {

constexpr double kEdgeOn = 1e-9;  // sine of the angle to a face seen edge-on
constexpr size_t kEntriesBetweenChecks = 1 << 16;

std::vector<Index> all_of(std::span<const Body> bodies) {
  std::vector<Index> out(bodies.size());
  for (size_t i = 0; i < out.size(); ++i) out[i] = static_cast<Index>(i);
  return out;
}

// Draws every face of a layer, on many threads, each with its own sink.
template <class Sink, class Make>
void draw_all(const Layer& layer, const View& view, int num_threads, Make make) {
  // A thread draws a run of faces with a sink of its own.
  for_each_part(layer.num_faces(), num_threads, [&](size_t, size_t first, size_t last) {
    TriangleRaster raster(view);
    Sink sink = make();
    for (size_t f = first; f < last && !sink.full(); ++f) {
      sink.face = static_cast<std::uint32_t>(f);
      if (!sink.is_outside()) raster.draw(layer.corners(sink.face), sink);
    }
  });
}

// Counts entries per pixel; gives up when there are too many.
class CountSink final : public SpanSink {
 public:
  CountSink(std::vector<std::uint64_t>& counts, std::vector<char>& is_inside, int width,
            std::atomic<size_t>& total, size_t most)
      : m_counts(counts), m_is_inside(is_inside), m_width(width), m_total(total), m_most(most) {}
  ~CountSink() { m_total += m_new; }
  bool is_outside() const { return false; }  // that is not known yet
  void span(const Span& s) override {
    m_is_inside[face] = 1;
    // Threads share the counters, and add to them without order: sums do not depend on it.
    std::uint64_t* count = &m_counts[size_t(s.row) * m_width + s.first];
    for (int i = 0; i < s.count; ++i)
      std::atomic_ref(count[i]).fetch_add(1, std::memory_order_relaxed);
    m_new += static_cast<size_t>(s.count);
  }
  bool full() {
    // The total is updated now and then, as threads would wait for each other otherwise.
    if (m_new >= kEntriesBetweenChecks) m_total += std::exchange(m_new, 0);
    return m_total.load(std::memory_order_relaxed) > m_most;
  }

 private:
  std::vector<std::uint64_t>& m_counts;
  std::vector<char>& m_is_inside;  // by face
  int m_width;
  std::atomic<size_t>& m_total;
  size_t m_most, m_new = 0;
};

// Stores entries in their places, unordered within a pixel.
class StoreSink final : public SpanSink {
 public:
  StoreSink(const Layer& layer, const std::vector<char>& is_inside, int width,
            std::vector<std::uint64_t>& next, std::vector<ZListItem>& items)
      : m_layer(layer), m_is_inside(is_inside), m_width(width), m_next(next), m_items(items) {}
  bool is_outside() const { return !m_is_inside[face]; }
  void span(const Span& s) override {
    const Layer::FaceId id = m_layer.id(face);
    // Each entry takes the next free place of its pixel.
    std::uint64_t* next = &m_next[size_t(s.row) * m_width + s.first];
    for (int i = 0; i < s.count; ++i) {
      const size_t at = std::atomic_ref(next[i]).fetch_add(1, std::memory_order_relaxed);
      m_items[at] = {static_cast<std::uint32_t>(id.body), static_cast<std::uint32_t>(id.face),
                     s.lower[i], s.upper[i],
                     s.centre_error <= kLargestCentreError ? s.centre[i] : std::nanf("")};
    }
  }
  bool full() const { return false; }

 private:
  const Layer& m_layer;
  const std::vector<char>& m_is_inside;
  int m_width;
  std::vector<std::uint64_t>& m_next;
  std::vector<ZListItem>& m_items;
};

bool nearer(const ZListItem& a, const ZListItem& b) {
  return std::tie(a.lower, a.upper, a.body, a.face) < std::tie(b.lower, b.upper, b.body, b.face);
}

// Sign for whether a line of sight enters at a face's front; MassProperties defines solids.
signed char winding_of(const Shape& shape) {
  if (shape.mass.rule != MassRule::Volume) return 0;
  // The signed volume tells whether faces run outwards or inwards.
  const Vec3 origin = shape.box.centre();
  double volume = 0;
  for (Index f = 0; f < static_cast<Index>(shape.mesh.triangles.size()); ++f) {
    const Triangle t = shape.mesh.triangle(f);
    volume += (t[0] - origin).cross(t[1] - origin).dot(t[2] - origin);
  }
  return volume < 0 ? -1 : 1;
}

}  // namespace

const char* to_string(Crossing crossing) {
  switch (crossing) {
    case Crossing::Enters:
      return "enters";
    case Crossing::Leaves:
      return "leaves";
    case Crossing::Along:
      return "along";
    default:
      return "unknown";
  }
}

CompleteZLists::CompleteZLists(std::span<const Body> bodies, const ProjectionOptions& options)
    : m_bodies(bodies), m_projection(projection_of(bodies, options)) {
  const int threads = options.num_threads > 0 ? options.num_threads : num_threads_here();
  for (const Body& body : bodies) m_winding.push_back(winding_of(*body.shape));
  if (m_projection.width == 0) return;
  const size_t num_pixels = size_t(m_projection.width) * m_projection.height;
  require(num_pixels * sizeof(m_ends[0]) <= options.most_bytes,
          say("%1 need more than the %2 MiB allowed", size_text(), options.most_bytes >> 20));
  draw(options.most_bytes, threads);
  // Entries of a pixel come in any order; sorting makes the result the same for all numbers of
  // threads.
  for_each_part(num_pixels, threads, [&](size_t, size_t first, size_t last) {
    for (size_t i = first; i < last; ++i)
      std::sort(m_items.begin() + (i ? m_ends[i - 1] : 0), m_items.begin() + m_ends[i], nearer);
  });
}

void CompleteZLists::draw(size_t most_bytes, int num_threads) {
  const ZListFrame frame = frame_of(m_projection);
  const Layer layer(frame, m_bodies, all_of(m_bodies));
  const View view = View::whole(frame, false);
  m_ends.resize(size_t(view.width) * view.height);
  const size_t most = (most_bytes - m_ends.size() * sizeof(m_ends[0])) / sizeof(ZListItem);
  std::atomic<size_t> total = 0;
  // Faces are drawn twice: once to count the entries of each pixel, once to store them in their
  // places. Those outside of the region are left out of the second time.
  std::vector<char> is_inside(layer.num_faces(), 0);
  draw_all<CountSink>(layer, view, num_threads,
                      [&] { return CountSink(m_ends, is_inside, view.width, total, most); });
  require(total <= most, say("%1 have more than %2 entries, the most that fit into the %3 MiB "
                             "allowed; take fewer pixels or a smaller region",
                             size_text(), most, most_bytes >> 20));
  // Items of a pixel start where those of the previous one end; storing advances each start to its
  // end.
  std::uint64_t start = 0;
  for (std::uint64_t& next : m_ends) start += std::exchange(next, start);
  m_items.resize(total);
  draw_all<StoreSink>(layer, view, num_threads,
                      [&] { return StoreSink(layer, is_inside, view.width, m_ends, m_items); });
}

std::string CompleteZLists::size_text() const {
  return "z-lists of " + std::to_string(m_projection.width) + " x " +
         std::to_string(m_projection.height) + " pixels";
}

std::span<const ZListItem> CompleteZLists::list(int column, int row) const {
  const size_t at = size_t(row) * m_projection.width + column;
  const std::uint64_t first = at > 0 ? m_ends[at - 1] : 0;
  return {m_items.data() + first, m_ends[at] - first};
}

Crossing CompleteZLists::crossing(const ZListItem& item) const {
  // Only a solid has an inside that a line of sight could enter.
  if (m_winding[item.body] == 0) return Crossing::Unknown;
  const Triangle t = m_bodies[item.body].triangle(static_cast<Index>(item.face));
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double along = m_winding[item.body] * n.dot(m_projection.direction);
  if (std::abs(along) <= kEdgeOn * n.norm()) return Crossing::Along;
  return along < 0 ? Crossing::Enters : Crossing::Leaves;
}

std::size_t CompleteZLists::num_bytes() const {
  return m_ends.size() * sizeof(m_ends[0]) + m_items.size() * sizeof(m_items[0]);
}

std::size_t CompleteZLists::num_covered() const {
  std::size_t out = 0;
  for (size_t i = 0; i < m_ends.size(); ++i) out += m_ends[i] > (i ? m_ends[i - 1] : 0);
  return out;
}

std::size_t CompleteZLists::longest() const {
  std::size_t out = 0;
  for (size_t i = 0; i < m_ends.size(); ++i)
    out = std::max<std::size_t>(out, m_ends[i] - (i ? m_ends[i - 1] : 0));
  return out;
}

}  // namespace trivet
