#include "raster/height_map/height_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "raster/zlist/draw_faces.h"

namespace trivet {
namespace {

constexpr float kNothingBelow = static_cast<float>(kInfinity);
// float32 rounding of a sum and a product of heights, relative.
constexpr float kRounding = 4e-7F;

ZListFrame frame_of(const MapGrid& grid, double growth) {
  ZListFrame frame;
  frame.width = grid.width;
  frame.height = grid.height;
  frame.pixel = grid.pixel;
  frame.growth = growth / grid.pixel;
  frame.origin = Vec3(grid.corner.x(), grid.corner.y(), grid.level);
  return frame;
}

// Rounds outwards by the possible rounding error, in metres.
float lowered(float height) { return height - kRounding * std::abs(height); }
float raised(float height) { return height + kRounding * std::abs(height); }

bool beside(const Aabb& box, const MapGrid& grid) {
  const Vec2 end = grid.corner + grid.pixel * Vec2(grid.width + 1, grid.height + 1);
  const Vec2 start = grid.corner - Vec2::Constant(grid.pixel);
  return (box.upper.head<2>().array() < start.array()).any() ||
         (box.lower.head<2>().array() > end.array()).any();
}

/// One side of what is drawn, in pixels: the highest (kTop) or the lowest depths, and those that
/// the lines through the centres meet for certain.
template <bool kTop>
class SideSink final : public SpanSink {
 public:
  explicit SideSink(HeightMap& map) : m_map(map) {}
  // A depth never exceeds its triangle's by more than `centre_error`, which is taken off again.
  bool is_hidden(const PixelBox& box, float lower, float upper) const override {
    const float best = kTop ? upper : lower;
    const auto hides = [&](float height) { return kTop ? height >= best : height <= best; };
    for (int row = box.first_row; row <= box.last_row; ++row)
      for (int column = box.first_column; column <= box.last_column; ++column) {
        const size_t at = m_map.index(column, row);
        if (!hides(m_map.sample[at]) || !hides(m_map.bound[at])) return false;
      }
    return true;
  }
  void span(const Span& s) override {
    const size_t at = m_map.index(s.first, s.row);
    float *bound = &m_map.bound[at], *sample = &m_map.sample[at];
    for (int i = 0; i < s.count; ++i)
      bound[i] = kTop ? std::max(bound[i], s.upper[i]) : std::min(bound[i], s.lower[i]);
    if (!(s.centre_error <= kLargestCentreError)) return;
    for (int i = 0; i < s.count; ++i) {
      const float met = kTop ? s.centre[i] - s.centre_error : s.centre[i] + s.centre_error;
      const bool better = kTop ? met > sample[i] : met < sample[i];  // false for NaN
      sample[i] = better ? met : sample[i];
    }
  }

 private:
  HeightMap& m_map;
};

bool faces_up(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) > (b.y() - a.y()) * (c.x() - a.x());
}

template <bool kTop>
HeightMap draw(std::span<const Body> bodies, const MapGrid& grid, const View& view,
               double ceiling) {
  HeightMap map(grid.width, grid.height, kTop ? -kNothingBelow : kNothingBelow);
  SideSink<kTop> sink(map);
  TriangleRaster raster(view);
  const double highest = (ceiling - grid.level) / grid.pixel;
  std::vector<const Index3*> later;
  for (const Body& body : bodies) {
    if (beside(body.world_box, grid) || body.world_box.lower.z() > ceiling) continue;
    const Affine pixels = view.frame->pixels_from_object(body);
    std::vector<Vec3> corners;
    for (const Vec3& v : body.shape->mesh.vertices) corners.push_back(pixels.apply(v));
    const auto draw_face = [&](const Index3& t) {
      const Triangle triangle{corners[t[0]], corners[t[1]], corners[t[2]]};
      if (std::min({triangle[0].z(), triangle[1].z(), triangle[2].z()}) > highest) return;
      raster.draw(triangle, sink);
    };
    // Faces that are seen come first: they hide most of the others.
    later.clear();
    for (const Index3& t : body.shape->mesh.triangles)
      if (faces_up(corners[t[0]], corners[t[1]], corners[t[2]]) == kTop)
        draw_face(t);
      else
        later.push_back(&t);
    for (const Index3* const t : later) draw_face(*t);
  }
  return map;
}

/// Maxima of a row's reaches, linear for any reach: by running maxima from the left and from the
/// right ends of blocks of its length [van Herk 1992].
class ReachOfRow {
 public:
  ReachOfRow(int width, int border)
      : m_left(width + 2 * border), m_right(m_left.size()), m_highest(width) {}

  /// The maximum of row[x - half .. x + half], for each x of the width.
  const std::vector<float>& highest(const float* row, int half) {
    const int length = 2 * half + 1, count = static_cast<int>(m_highest.size()) + 2 * half;
    const float* first = row - half;
    for (int begin = 0; begin < count; begin += length) {
      const int end = std::min(begin + length, count);
      m_left[begin] = first[begin];
      for (int i = begin + 1; i < end; ++i) m_left[i] = std::max(m_left[i - 1], first[i]);
      m_right[end - 1] = first[end - 1];
      for (int i = end - 2; i >= begin; --i) m_right[i] = std::max(m_right[i + 1], first[i]);
    }
    for (size_t x = 0; x < m_highest.size(); ++x)
      m_highest[x] = std::max(m_right[x], m_left[x + 2 * half]);
    return m_highest;
  }

 private:
  std::vector<float> m_left, m_right, m_highest;
};

void take_higher(const std::vector<float>& row, HeightMap& map, int y) {
  float* const out = &map.bound[map.index(0, y)];
  for (int x = 0; x < map.width; ++x) out[x] = std::max(out[x], row[x]);
}

}  // namespace

MapGrid MapGrid::about(const Aabb& box, double pixel, double level) {
  MapGrid out;
  const Vec2 size = (box.upper - box.lower).head<2>();
  out.pixel = pixel;
  out.level = level;
  out.width = static_cast<int>(std::ceil(size.x() / pixel)) + 2;
  out.height = static_cast<int>(std::ceil(size.y() / pixel)) + 2;
  out.corner = box.centre().head<2>() - 0.5 * pixel * Vec2(out.width, out.height);
  return out;
}

HeightMap draw_underside(std::span<const Body> bodies, const MapGrid& grid, double growth) {
  HeightMap out(grid.width, grid.height, kNothingBelow);
  const ZListFrame frame = frame_of(grid, growth);
  const HeightMap map = draw<false>(bodies, grid, View::whole(frame, true), kInfinity);
  const auto pixel = static_cast<float>(grid.pixel);
  for (size_t i = 0; i < out.bound.size(); ++i) {
    if (map.bound[i] < kNothingBelow) out.bound[i] = lowered(pixel * map.bound[i]);
    if (map.sample[i] < kNothingBelow) out.sample[i] = raised(pixel * map.sample[i]);
  }
  return out;
}

HeightMap draw_top(std::span<const Body> bodies, const MapGrid& grid, bool floor, double ceiling) {
  HeightMap out(grid.width, grid.height, -kNothingBelow);
  if (floor) {
    const auto height = static_cast<float>(-grid.level);
    std::fill(out.bound.begin(), out.bound.end(), raised(height));
    std::fill(out.sample.begin(), out.sample.end(), lowered(height));
  }
  const ZListFrame frame = frame_of(grid, 0);
  const HeightMap map = draw<true>(bodies, grid, View::whole(frame, false), ceiling);
  const auto pixel = static_cast<float>(grid.pixel);
  for (size_t i = 0; i < out.bound.size(); ++i) {
    if (map.bound[i] > -kNothingBelow)
      out.bound[i] = std::max(out.bound[i], raised(pixel * map.bound[i]));
    if (map.sample[i] > -kNothingBelow)
      out.sample[i] = std::max(out.sample[i], lowered(pixel * map.sample[i]));
  }
  return out;
}

HeightMap widened_top(const HeightMap& map, double pixels, int border) {
  HeightMap out(map.width - 2 * border, map.height - 2 * border, -kNothingBelow);
  const auto r = static_cast<int>(pixels);
  assert(r <= border);
  ReachOfRow reach(out.width, border);
  // Each row of the map raises those above and below it that are within reach.
  const auto is_in = [&](int y) { return y >= 0 && y < out.height; };
  for (int y = -r; y < out.height + r; ++y)
    for (int dy = 0; dy <= r; ++dy) {
      if (!is_in(y - dy) && !is_in(y + dy)) continue;
      const auto half = static_cast<int>(std::sqrt(pixels * pixels - dy * dy));
      const auto& highest = reach.highest(&map.bound[map.index(border, y + border)], half);
      if (is_in(y - dy)) take_higher(highest, out, y - dy);
      if (dy > 0 && is_in(y + dy)) take_higher(highest, out, y + dy);
    }
  return out;
}

}  // namespace trivet
