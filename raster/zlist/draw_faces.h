// Draws all faces of a layer, with a fast path for small ones. Private.
#pragma once

#include <cmath>
#include <limits>

#include "raster/zlist/angles.h"
#include "raster/zlist/layer.h"
#include "raster/zlist/triangle_raster.h"

namespace trivet {

/// A face within 2 x 2 pixels.
struct SmallFace {
  std::uint32_t face;
  int x0, y0, x1, y1;  // pixels, inclusive
  float lower, upper;  // depths
  bool centres;        // may contain the centre of a pixel
};

/// Region of interest; faces outside are culled.
struct Wanted {
  float lower, upper;  // depths
  int x0, y0, x1, y1;  // pixels, inclusive

  static Wanted all_of(const View& view) {
    return {-kFloatInfinity, kFloatInfinity, 0, 0, view.width - 1, view.height - 1};
  }
  bool has_depths(float from, float to) const { return to >= lower && from <= upper; }
};

/// Radians. Faces with a longer arc do not count as small; also bounds the growth of angles of
/// moving faces where faces are small.
inline constexpr float kLongestArc = 0.5F;
inline constexpr double kCopyMargin = 0.45;
/// Centres with a less certain depth (pixels or radians) are not used.
inline constexpr float kLargestCentreError = 0.02F;

/// Finds the small faces of one body of a layer; the others are for TriangleRaster.
class SmallFaces {
 public:
  SmallFaces(const Layer::Member& member, const View& view, const Wanted& wanted)
      : m_view(view),
        m_vertices(member.vertices),
        m_position_error(static_cast<float>(member.position_error)),
        m_depth_error(static_cast<float>(member.depth_error)),
        m_first_radius(static_cast<float>(view.frame->first_radius)),
        m_smallest_radius(static_cast<float>(1 + 4 * view.frame->growth)) {
    const auto margin =
        static_cast<float>(kRoundingPixels + view.growth() + 2 * member.position_error);
    m_margin = {margin, margin,
                static_cast<float>(2 * member.depth_error + (view.moving ? view.frame->growth : 0)),
                0};
    m_low = {static_cast<float>(wanted.x0), static_cast<float>(wanted.y0), wanted.lower, -1};
    m_high = {static_cast<float>(wanted.x1 + 1), static_cast<float>(wanted.y1 + 1), wanted.upper,
              1};
    m_first = {wanted.x0, wanted.y0, 0, 0};
    m_last = {wanted.x1, wanted.y1, 0, 0};
  }

  enum class Kind { Outside, Small, Large };

  /// Along a direction, small faces' centres come from sample_centres().
  Kind classify(const Index3& t, SmallFace& out) const {
    const ImageVertex &a = m_vertices[t[0]], &b = m_vertices[t[1]], &c = m_vertices[t[2]];
    const ImageVertex low = a.min(b).min(c) - m_margin, high = a.max(b).max(c) + m_margin;
    if ((high - m_low).min(m_high - low).minCoeff() < 0) return Kind::Outside;
    return small_box(low, high, out) ? Kind::Small : Kind::Large;
  }

  /// Along a direction: whether a face with vertices in this box is outside.
  bool is_outside(const ImageVertex& low, const ImageVertex& high) const {
    return (high + m_margin - m_low).min(m_high - low + m_margin).minCoeff() < 0;
  }
  /// Grows a box to hold the face.
  void note(const Index3& t, ImageVertex& low, ImageVertex& high) const {
    const ImageVertex &a = m_vertices[t[0]], &b = m_vertices[t[1]], &c = m_vertices[t[2]];
    low = low.min(a.min(b).min(c));
    high = high.max(a.max(b).max(c));
  }

  /// The same for a rotation. @param centres  faces that may contain a pixel's centre are not
  /// small.
  Kind classify_turning(const Index3& t, bool centres, SmallFace& out) const {
    ImageVertex a = m_vertices[t[0]], b = m_vertices[t[1]], c = m_vertices[t[2]];
    // Angles of one face are brought within half a turn of each other before their range is taken.
    unwrap(a, b), unwrap(a, c);
    ImageVertex low = a.min(b).min(c), high = a.max(b).max(c);
    const float arc = high[2] - low[2];
    const bool narrow = low[0] + m_first_radius > m_smallest_radius && arc < kLongestArc;
    // A straight side bends towards the axis between its ends, by about r angle^2 / 8.
    if (narrow) low[0] -= (high[0] + m_first_radius) * arc * arc / 8;  // bulge
    low -= m_margin, high += m_margin;
    // A face near the axis, or of a long arc, has no small box: its rows alone can leave it out.
    if (!narrow) return high[1] < m_low[1] || low[1] > m_high[1] ? Kind::Outside : Kind::Large;
    if ((high - m_low).min(m_high - low).head<2>().minCoeff() < 0) return Kind::Outside;
    if (!small_box(low, high, out)) return Kind::Large;
    if (centres && out.centres) return Kind::Large;
    // The margin of angles is that of the face's first column: nearer the axis it is larger.
    const float margin = turning_margin(out.x0) - m_margin[2];
    out.lower -= margin;
    out.upper += margin;
    return Kind::Small;
  }

  /// Calls sample(pixel, depth, error) for pixels of a small face, along a direction, whose centre
  /// is certainly inside it, by the same 0.01 pixels as in TriangleRaster.
  template <class Sample>
  void sample_centres(const Index3& t, const SmallFace& face, Sample sample) const {
    const ImageVertex &a = m_vertices[t[0]], &b = m_vertices[t[1]], &c = m_vertices[t[2]];
    // Coordinates below are within 3 pixels of the centre: products are within 9, sums within 18.
    const float blur = m_position_error + 1e-6F, error = 12 * blur + 4e-6F;
    for (int y = face.y0; y <= face.y1; ++y)
      for (int x = face.x0; x <= face.x1; ++x) {
        const float px = static_cast<float>(x) + 0.5F, py = static_cast<float>(y) + 0.5F;
        const float ax = a[0] - px, ay = a[1] - py, bx = b[0] - px, by = b[1] - py;
        const float cx = c[0] - px, cy = c[1] - py;
        float wa = bx * cy - by * cx, wb = cx * ay - cy * ax, wc = ax * by - ay * bx;
        const float sum = wa + wb + wc;
        if (sum < 0) wa = -wa, wb = -wb, wc = -wc;
        constexpr auto kInside = static_cast<float>(kRoundingPixels);
        if (!(wa > error + kInside * (std::abs(bx - cx) + std::abs(by - cy))) ||
            !(wb > error + kInside * (std::abs(cx - ax) + std::abs(cy - ay))) ||
            !(wc > error + kInside * (std::abs(ax - bx) + std::abs(ay - by))))
          continue;
        const float area = std::abs(sum), db = b[2] - a[2], dc = c[2] - a[2];
        const float depth = a[2] + (wb * db + wc * dc) / area;
        const float uncertain = 4 * error / area * (std::abs(db) + std::abs(dc)) +
                                2 * m_depth_error +
                                5e-7F * (std::abs(a[2]) + std::abs(db) + std::abs(dc));
        if (uncertain <= kLargestCentreError) sample(y * m_view.width + x, depth, uncertain);
      }
  }

 private:
  // Grown by all margins; false if wholly outside the window.
  bool small_box(const ImageVertex& low, const ImageVertex& high, SmallFace& out) const {
    if (!(high[0] - low[0] < 3) || !(high[1] - low[1] < 3)) return false;
    const Eigen::Array4i first = low.max(0).cast<int>().max(m_first);
    const Eigen::Array4i last = high.min(m_high).cast<int>().min(m_last);
    if (last[0] - first[0] > 1 || last[1] - first[1] > 1) return false;
    out.x0 = first[0];
    out.y0 = first[1];
    out.x1 = last[0];
    out.y1 = last[1];
    out.lower = low[2];
    out.upper = high[2];
    // Columns and rows of centres up to here, and before; negative ones are irrelevant.
    const Eigen::Array4i up_to = (high + 0.5F).cast<int>(),
                         before = (low.max(0) + 0.5F).cast<int>();
    out.centres = up_to[0] >= before[0] + 1 && up_to[1] >= before[1] + 1;
    return true;
  }
  static void unwrap(const ImageVertex& a, ImageVertex& b) {
    constexpr auto kPiF = static_cast<float>(kPi), kTurnF = static_cast<float>(kTurn);
    const float d = b[2] - a[2];
    if (d > kPiF) b[2] -= kTurnF;
    if (d < -kPiF) b[2] += kTurnF;
  }
  float turning_margin(int column) const {
    const ZListFrame& frame = *m_view.frame;
    const double growth =
        m_view.moving ? frame.depth_growth(frame.first_radius + column - kRoundingPixels) : 0;
    return static_cast<float>(growth + 4e-6);
  }

  const View& m_view;
  const std::vector<ImageVertex>& m_vertices;
  float m_position_error, m_depth_error, m_first_radius, m_smallest_radius;
  ImageVertex m_margin, m_low, m_high;  // (columns, rows, depths, unused)
  Eigen::Array4i m_first, m_last;
};

/// Boxes of runs of faces along a direction, of vertices without margins: the first pass over all
/// faces records them, later ones skip runs outside their region of interest at once.
struct FaceBoxes {
  static constexpr size_t kRun = 64;  // faces; parts of a pass begin at multiples of it
  bool noted = false;
  std::vector<ImageVertex> low, high;

  explicit FaceBoxes(size_t num_faces)
      : low(num_faces / kRun + 1, ImageVertex::Constant(kFloatInfinity)),
        high(low.size(), -low.front()) {}
  void add(size_t run, const ImageVertex& from, const ImageVertex& to) {
    low[run] = low[run].min(from);
    high[run] = high[run].max(to);
  }
};

/// Draws one face; see draw_faces().
template <bool kTurning, class Sink>
bool draw_face(const Layer& layer, const SmallFaces& finder, const Wanted& wanted, const Index3& t,
               SmallFace& found, TriangleRaster& raster, Sink& sink) {
  const auto kind =
      kTurning ? finder.classify_turning(t, Sink::kCentres, found) : finder.classify(t, found);
  if (kind == SmallFaces::Kind::Outside) return true;
  if (kind == SmallFaces::Kind::Large) {
    sink.face = found.face;
    return raster.draw(layer.corners(found.face), sink);
  }
  if constexpr (kTurning) {
    // A small face of a rotation comes once for each whole turn that may meet the region's depths.
    raster.for_each_copy(found.lower - kCopyMargin, found.upper + kCopyMargin, [&](double shift) {
      SmallFace copy = found;
      copy.lower += static_cast<float>(shift);
      copy.upper += static_cast<float>(shift);
      if (wanted.has_depths(copy.lower, copy.upper)) sink.small(copy);
    });
  } else {
    sink.small(found);
    if constexpr (Sink::kCentres)
      if (found.centres)
        finder.sample_centres(t, found, [&](int pixel, float depth, float error) {
          sink.sample(pixel, depth, error);
        });
  }
  return true;
}

/// Draws every `stride`-th face in [first, last) of a projected layer inside the region of
/// interest, in a view of the whole image. A sink takes small(SmallFace) for small faces and, if it
/// has kCentres, sample(pixel, depth, error) on lines through centres that meet them; other faces
/// go to it as a SpanSink. A small fixed face of a rotation may come several times, once per angle.
/// @param boxes  of the layer's faces, read or recorded; null: not used.
/// @return false if a face had too many pieces.
template <bool kTurning, class Sink>
bool draw_faces(const Layer& layer, const View& view, const Wanted& wanted, size_t first,
                size_t last, size_t stride, TriangleRaster& raster, Sink& sink,
                FaceBoxes* boxes = nullptr) {
  bool complete = true;
  for (const Layer::Member& m : layer.members()) {
    const std::vector<Index3>& faces = m.source->shape->mesh.triangles;
    const SmallFaces finder(m, view, wanted);
    const size_t end = std::min<size_t>(last, m.first_face + faces.size());
    SmallFace found{};
    for (size_t f = std::max<size_t>(first, m.first_face); f < end;) {
      // Whole runs are skipped by the box that the first pass noted for them.
      const size_t run = f / FaceBoxes::kRun;
      const size_t run_end = boxes ? std::min(end, (run + 1) * FaceBoxes::kRun) : end;
      if (boxes && boxes->noted && finder.is_outside(boxes->low[run], boxes->high[run])) {
        f = run_end;
        continue;
      }
      // Boxes are noted where every face is seen: passes with a stride are given none.
      const bool notes = boxes && !boxes->noted;
      ImageVertex low = ImageVertex::Constant(kFloatInfinity), high = -low;
      for (; f < run_end; f += stride) {
        const Index3& t = faces[f - m.first_face];
        if (notes) finder.note(t, low, high);
        found.face = static_cast<std::uint32_t>(f);
        complete &= draw_face<kTurning>(layer, finder, wanted, t, found, raster, sink);
      }
      if (notes) boxes->add(run, low, high);
    }
  }
  return complete;
}

}  // namespace trivet
