#include "raster/height_map/height_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "raster/zlist/depth_map.h"

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

DepthMap draw(std::span<const Body> bodies, const MapGrid& grid, const View& view, double ceiling) {
  DepthMap map(grid.width, grid.height);
  DepthMapSink sink(map);
  TriangleRaster raster(view);
  const double highest = (ceiling - grid.level) / grid.pixel;
  for (const Body& body : bodies) {
    if (beside(body.world_box, grid) || body.world_box.lower.z() > ceiling) continue;
    const Affine pixels = view.frame->pixels_from_object(body);
    std::vector<Vec3> corners;
    for (const Vec3& v : body.shape->mesh.vertices) corners.push_back(pixels.apply(v));
    for (const Index3& t : body.shape->mesh.triangles) {
      const Triangle triangle{corners[t[0]], corners[t[1]], corners[t[2]]};
      if (std::min({triangle[0].z(), triangle[1].z(), triangle[2].z()}) > highest) continue;
      raster.draw(triangle, sink);
    }
  }
  return map;
}

// out[x] = max(out[x], maximum of row[x - half .. x + half]); linear for any `half`: running maxima
// from the left and from the right ends of blocks of that length [van Herk 1992].
void take_highest_in_reach(const float* row, int half, std::span<float> out) {
  const int length = 2 * half + 1, count = static_cast<int>(out.size()) + 2 * half;
  std::vector<float> from_left(count), from_right(count);
  const float* first = row - half;
  for (int i = 0; i < count; ++i)
    from_left[i] = i % length == 0 ? first[i] : std::max(from_left[i - 1], first[i]);
  for (int i = count - 1; i >= 0; --i)
    from_right[i] =
        i + 1 == count || (i + 1) % length == 0 ? first[i] : std::max(from_right[i + 1], first[i]);
  for (size_t x = 0; x < out.size(); ++x)
    out[x] = std::max({out[x], from_right[x], from_left[x + 2 * half]});
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
  const DepthMap map = draw(bodies, grid, View::whole(frame, true), kInfinity);
  const auto pixel = static_cast<float>(grid.pixel);
  for (size_t i = 0; i < out.bound.size(); ++i) {
    if (map.lower[i] < kNothingBelow) out.bound[i] = lowered(pixel * map.lower[i]);
    if (map.lowest_centre[i] < kNothingBelow) out.sample[i] = raised(pixel * map.lowest_centre[i]);
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
  const DepthMap map = draw(bodies, grid, View::whole(frame, false), ceiling);
  const auto pixel = static_cast<float>(grid.pixel);
  for (size_t i = 0; i < out.bound.size(); ++i) {
    if (map.upper[i] > -kNothingBelow)
      out.bound[i] = std::max(out.bound[i], raised(pixel * map.upper[i]));
    if (map.highest_centre[i] > -kNothingBelow)
      out.sample[i] = std::max(out.sample[i], lowered(pixel * map.highest_centre[i]));
  }
  return out;
}

HeightMap widened_top(const HeightMap& map, double pixels, int border) {
  HeightMap out(map.width - 2 * border, map.height - 2 * border, -kNothingBelow);
  const auto r = static_cast<int>(pixels);
  assert(r <= border);
  for (int dy = -r; dy <= r; ++dy) {
    const auto half = static_cast<int>(std::sqrt(pixels * pixels - dy * dy));
    for (int y = 0; y < out.height; ++y)
      take_highest_in_reach(&map.bound[map.index(border, y + border + dy)], half,
                            {&out.bound[out.index(0, y)], size_t(out.width)});
  }
  return out;
}

}  // namespace trivet
