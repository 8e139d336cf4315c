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

using Line = Eigen::Map<Eigen::ArrayXf>;

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

/// One side of what is drawn, in pixels: the highest (kTop) or the lowest depths, and, if the map
/// has samples, those that the lines through the centres meet for certain.
template <bool kTop>
class SideSink final : public SpanSink {
 public:
  explicit SideSink(HeightMap& map)
      : m_map(map), m_hiding(map.sample.empty() ? map.bound : map.sample) {}
  // A depth never exceeds its triangle's by more than `centre_error`, which is taken off again.
  bool is_hidden(const PixelBox& box, float lower, float upper) const override {
    // A face is hidden if it could better no pixel of its box.
    const float best = kTop ? upper : lower;
    const auto hides = [&](float height) { return kTop ? height >= best : height <= best; };
    for (int row = box.first_row; row <= box.last_row; ++row)
      for (int column = box.first_column; column <= box.last_column; ++column) {
        const size_t at = m_map.index(column, row);
        if (!hides(m_hiding[at]) || !hides(m_map.bound[at])) return false;
      }
    return true;
  }
  void span(const Span& s) override {
    const size_t at = m_map.index(s.first, s.row);
    float* const bound = &m_map.bound[at];
    for (int i = 0; i < s.count; ++i)
      bound[i] = kTop ? std::max(bound[i], s.upper[i]) : std::min(bound[i], s.lower[i]);
    // Centres that are known badly bound nothing.
    if (m_map.sample.empty() || !(s.centre_error <= kLargestCentreError)) return;
    float* const sample = &m_map.sample[at];
    for (int i = 0; i < s.count; ++i) {
      const float met = kTop ? s.centre[i] - s.centre_error : s.centre[i] + s.centre_error;
      const bool better = kTop ? met > sample[i] : met < sample[i];  // false for NaN
      sample[i] = better ? met : sample[i];
    }
  }

 private:
  HeightMap& m_map;
  const std::vector<float>& m_hiding;  // not better than the bounds, where there are samples
};

/// Faces in runs of neighbours, most of which are hidden together.
class HiddenRuns {
 public:
  static constexpr size_t kRun = 8;

  explicit HiddenRuns(const View& view) : m_view(view) {}

  /// All pixels and depths of the faces, and a little more.
  template <class Sink>
  bool hides(std::span<const Index3* const> faces, const std::vector<Vec3>& corners,
             const Sink& sink) const {
    // The run's box grows by a pixel and by rounding, so that nothing of it is outside.
    Vec3 low = Vec3::Constant(kInfinity), high = -low;
    for (const Index3* const t : faces)
      for (const Index v : *t) low = low.cwiseMin(corners[v]), high = high.cwiseMax(corners[v]);
    const double about = 1 + m_view.growth();
    const auto pixel = [&](double x, int size) {
      return static_cast<int>(std::clamp(x, -1.0, static_cast<double>(size)));
    };
    const PixelBox box{std::max(pixel(low.y() - about, m_view.height), 0),
                       std::min(pixel(high.y() + about, m_view.height), m_view.height - 1),
                       std::max(pixel(low.x() - about, m_view.width), 0),
                       std::min(pixel(high.x() + about, m_view.width), m_view.width - 1)};
    const double grown = 1e-6 * std::max(std::abs(low.z()), std::abs(high.z())) +
                         (m_view.moving ? m_view.frame->growth : 0);
    return sink.is_hidden(box, static_cast<float>(low.z() - grown),
                          static_cast<float>(high.z() + grown));
  }

 private:
  const View& m_view;
};

bool faces_up(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) > (b.y() - a.y()) * (c.x() - a.x());
}

template <bool kTop>
HeightMap draw(std::span<const Body> bodies, const MapGrid& grid, const View& view, double ceiling,
               MapParts parts) {
  HeightMap map(grid.width, grid.height, kTop ? -kNothingBelow : kNothingBelow);
  const bool has_samples = parts == MapParts::All;
  if (!has_samples) map.sample.clear();
  SideSink<kTop> sink(map);
  TriangleRaster raster(view, has_samples);
  const HiddenRuns runs(view);
  // Faces wholly above the ceiling are left out.
  const double highest = (ceiling - grid.level) / grid.pixel;
  std::vector<Vec3> corners;
  std::vector<const Index3*> later;
  for (const Body& body : bodies) {
    // Bodies beside the map cannot be seen in it.
    if (beside(body.world_box, grid) || body.world_box.lower.z() > ceiling) continue;
    const Affine pixels = view.frame->pixels_from_object(body);
    const std::vector<Vec3>& vertices = body.shape->mesh.vertices;
    corners.resize(vertices.size());
    for (size_t v = 0; v < vertices.size(); ++v) corners[v] = pixels.apply(vertices[v]);
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
    for (size_t first = 0; first < later.size(); first += HiddenRuns::kRun) {
      const std::span<const Index3* const> run(&later[first],
                                               std::min(HiddenRuns::kRun, later.size() - first));
      if (runs.hides(run, corners, sink)) continue;
      for (const Index3* const t : run) draw_face(*t);
    }
  }
  return map;
}

/// Maxima of a row's reaches.
class ReachOfRow {
 public:
  explicit ReachOfRow(int width) : m_width(width) {}

  /// The maximum of row[x - half .. x + half], for each x of the width.
  Line highest(const float* row, int half) {
    // Reaches begin and end outside the row, as the map has a border.
    m_highest.assign(row - half, row + m_width + half);
    // Two windows that overlap make one, at most twice as long.
    const int wanted = 2 * half + 1;
    for (int length = 1, more = 0; length < wanted; length += more) {
      more = std::min(length, wanted - length);
      const auto count = static_cast<Eigen::Index>(m_highest.size()) - more;
      Line line(m_highest.data(), count);
      line = line.max(Line(m_highest.data() + more, count));
    }
    return {m_highest.data(), m_width};
  }

 private:
  int m_width;
  std::vector<float> m_highest;
};

void take_higher(const Line& row, HeightMap& map, int y) {
  Line out(&map.bound[map.index(0, y)], map.width);
  out = out.max(row);
}

// Heights of pixels in metres, rounded upwards or downwards, at least `least`; that is what NaN
// becomes, of pixels without height.
void to_metres(std::vector<float>& heights, float pixel, float rounding, float least) {
  Line line(heights.data(), static_cast<Eigen::Index>(heights.size()));
  const auto metres = pixel * line;
  line = Eigen::ArrayXf::Constant(line.size(), least).max(metres + rounding * metres.abs());
}

}  // namespace

MapGrid MapGrid::about(const Aabb& box, double pixel, double level) {
  MapGrid out;
  const Vec2 size = (box.upper - box.lower).head<2>();
  // Two pixels more than the box, so that rounding never puts it outside.
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
  const HeightMap map =
      draw<false>(bodies, grid, View::whole(frame, true), kInfinity, MapParts::All);
  // Bounds are lowered and samples raised, so that both hold for the true heights.
  const auto pixel = static_cast<float>(grid.pixel);
  for (size_t i = 0; i < out.bound.size(); ++i) {
    if (map.bound[i] < kNothingBelow) out.bound[i] = lowered(pixel * map.bound[i]);
    if (map.sample[i] < kNothingBelow) out.sample[i] = raised(pixel * map.sample[i]);
  }
  return out;
}

HeightMap draw_top(std::span<const Body> bodies, const MapGrid& grid, bool floor, double ceiling,
                   MapParts parts) {
  const ZListFrame frame = frame_of(grid, 0);
  HeightMap map = draw<true>(bodies, grid, View::whole(frame, false), ceiling, parts);
  const auto pixel = static_cast<float>(grid.pixel), level = static_cast<float>(-grid.level);
  to_metres(map.bound, pixel, kRounding, floor ? raised(level) : -kNothingBelow);
  to_metres(map.sample, pixel, -kRounding, floor ? lowered(level) : -kNothingBelow);
  return map;
}

HeightMap widened_top(const HeightMap& map, double pixels, int border) {
  HeightMap out(map.width - 2 * border, map.height - 2 * border, -kNothingBelow);
  const auto r = static_cast<int>(pixels);
  assert(r <= border);
  ReachOfRow reach(out.width);
  // Each row of the map raises those above and below it that are within reach.
  const auto is_in = [&](int y) { return y >= 0 && y < out.height; };
  for (int y = -r; y < out.height + r; ++y)
    for (int dy = 0; dy <= r; ++dy) {
      if (!is_in(y - dy) && !is_in(y + dy)) continue;
      // At a distance of dy rows the disc reaches this many columns.
      const auto half = static_cast<int>(std::sqrt(pixels * pixels - dy * dy));
      const Line highest = reach.highest(&map.bound[map.index(border, y + border)], half);
      if (is_in(y - dy)) take_higher(highest, out, y - dy);
      if (dy > 0 && is_in(y + dy)) take_higher(highest, out, y + dy);
    }
  return out;
}

}  // namespace trivet
