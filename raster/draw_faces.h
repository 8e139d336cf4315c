// All faces of a layer, small ones at once. Private.
#pragma once

#include "raster/angles.h"
#include "raster/layer.h"
#include "raster/triangle_raster.h"

namespace trivet {

/// A face within 2 x 2 pixels, none of whose centres it may hold.
struct SmallFace {
  std::uint32_t face;
  int x0, y0, x1, y1;  // pixels, inclusive
  float lower, upper;  // depths
};

/// Radians. Faces with a longer arc are not small; by so much at most are angles of moving ones
/// grown where faces are small.
inline constexpr float kLongestArc = 0.5F;
inline constexpr double kCopyMargin = 0.45;

/// Finds the small faces of one body of a layer; the others are for TriangleRaster.
class SmallFaces {
 public:
  SmallFaces(const Layer::Member& member, const View& view)
      : m_view(view),
        m_vertices(member.vertices),
        m_margin(static_cast<float>(kRoundingPixels + view.growth() + 2 * member.position_error)),
        m_depth_margin(
            static_cast<float>(2 * member.depth_error + (view.moving ? view.frame->growth : 0))),
        m_first_radius(static_cast<float>(view.frame->first_radius)),
        m_smallest_radius(static_cast<float>(1 + 4 * view.frame->growth)) {}

  enum class Kind { Outside, Small, Large };

  template <bool kTurning>
  Kind classify(const Index3& t, SmallFace& out) const {
    ImageVertex a = m_vertices[t[0]], b = m_vertices[t[1]], c = m_vertices[t[2]];
    if constexpr (kTurning) unwrap(a, b), unwrap(a, c);
    ImageVertex low = a.min(b).min(c), high = a.max(b).max(c);
    float arc = 0;
    if constexpr (kTurning) {
      arc = high[2] - low[2];
      if (low[0] + m_first_radius > m_smallest_radius && arc < kLongestArc)
        low[0] -= (high[0] + m_first_radius) * arc * arc / 8;  // bulge
      else
        arc = 4;
    }
    const float left = low[0] - m_margin, right = high[0] + m_margin;
    const float bottom = low[1] - m_margin, top = high[1] + m_margin;
    if constexpr (kTurning)
      if (arc >= kLongestArc)
        return top < 0 || !(bottom < m_view.height) ? Kind::Outside : Kind::Large;
    if (right < 0 || top < 0 || !(left < m_view.width) || !(bottom < m_view.height))
      return Kind::Outside;
    if (!(right - left < 3) || !(top - bottom < 3)) return Kind::Large;
    out.x0 = static_cast<int>(std::max(left, 0.0F));
    out.y0 = static_cast<int>(std::max(bottom, 0.0F));
    out.x1 = std::min(static_cast<int>(right), m_view.width - 1);
    out.y1 = std::min(static_cast<int>(top), m_view.height - 1);
    if (out.x1 - out.x0 > 1 || out.y1 - out.y0 > 1) return Kind::Large;
    if (holds_half(left, right) && holds_half(bottom, top)) return Kind::Large;
    float margin = m_depth_margin;
    if constexpr (kTurning) margin = turning_margin(out.x0);
    out.lower = low[2] - margin;
    out.upper = high[2] + margin;
    return Kind::Small;
  }

 private:
  static void unwrap(const ImageVertex& a, ImageVertex& b) {
    constexpr auto kPiF = static_cast<float>(kPi), kTurnF = static_cast<float>(kTurn);
    const float d = b[2] - a[2];
    if (d > kPiF) b[2] -= kTurnF;
    if (d < -kPiF) b[2] += kTurnF;
  }
  // Some i + 1/2 in [low, high]; 0 < high - low < 3.
  static bool holds_half(float low, float high) { return std::floor(high - 0.5F) >= low - 0.5F; }
  float turning_margin(int column) const {
    const ZListFrame& frame = *m_view.frame;
    const double growth =
        m_view.moving ? frame.depth_growth(frame.first_radius + column - kRoundingPixels) : 0;
    return static_cast<float>(growth + 4e-6);
  }

  const View& m_view;
  const std::vector<ImageVertex>& m_vertices;
  float m_margin, m_depth_margin, m_first_radius, m_smallest_radius;
};

/// Draws every `stride`-th face in [first, last) of a projected layer, in a view of the whole
/// image: small(SmallFace) for small faces, `sink` for the others. A small fixed face of a turn may
/// come several times, once per angle.
/// @return false when a face had too many pieces.
template <bool kTurning, class Small>
bool draw_faces(const Layer& layer, const View& view, size_t first, size_t last, size_t stride,
                TriangleRaster& raster, SpanSink& sink, Small small) {
  bool complete = true;
  for (const Layer::Member& m : layer.members()) {
    const std::vector<Index3>& faces = m.source->shape->mesh.triangles;
    const SmallFaces finder(m, view);
    const size_t begin = std::max<size_t>(first, m.first_face);
    const size_t end = std::min<size_t>(last, m.first_face + faces.size());
    SmallFace found{};
    for (size_t f = begin; f < end; f += stride) {
      found.face = static_cast<std::uint32_t>(f);
      const auto kind = finder.template classify<kTurning>(faces[f - m.first_face], found);
      if (kind == SmallFaces::Kind::Outside) continue;
      if (kind == SmallFaces::Kind::Small) {
        if constexpr (kTurning)
          raster.for_each_copy(found.lower - kCopyMargin, found.upper + kCopyMargin,
                               [&](double shift) {
                                 SmallFace copy = found;
                                 copy.lower += static_cast<float>(shift);
                                 copy.upper += static_cast<float>(shift);
                                 small(copy);
                               });
        else
          small(found);
        continue;
      }
      sink.face = found.face;
      complete &= raster.draw(layer.corners(found.face), sink);
    }
  }
  return complete;
}

}  // namespace trivet
