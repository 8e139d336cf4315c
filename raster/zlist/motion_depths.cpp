#include "raster/zlist/motion_depths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "raster/zlist/depth_map.h"
#include "raster/zlist/fragment_sinks.h"

namespace trivet {
namespace {

/// Nearest fixed depth of each pixel that is not wholly behind the moving faces; lowers the upper
/// bound as the search does.
class FixedFrontSink final : public SpanSink {
 public:
  static constexpr bool kCentres = true;
  FixedFrontSink(const DepthMap& moving, SharedMinimum& upper, std::vector<float>& front)
      : m_moving(moving), m_bound(moving, upper), m_front(front) {
    m_bound.keep = false;
  }

  void span(const Span& s) override {
    m_bound.span(s);
    const int at = s.row * m_moving.width + s.first;
    for (int i = 0; i < s.count; ++i) add(at + i, s.lower[i], s.upper[i]);
  }
  void small(const SmallFace& f) {
    for (int y = f.y0; y <= f.y1; ++y)
      for (int x = f.x0; x <= f.x1; ++x) add(y * m_moving.width + x, f.lower, f.upper);
  }
  void sample(int pixel, float depth, float error) { m_bound.sample(pixel, depth, error); }

 private:
  void add(int pixel, float lower, float upper) {
    // A fixed face wholly behind the moving one cannot be met; one that reaches behind it counts
    // from its rear.
    const float rear = m_moving.empty_at(pixel) ? 0 : m_moving.lower[pixel];
    if (lower <= upper && upper >= rear)
      m_front[pixel] = std::min(m_front[pixel], std::max(lower, rear));
  }

  const DepthMap& m_moving;
  FixedSink m_bound;
  std::vector<float>& m_front;
};

bool draw_fixed(const Layer& layer, const View& view, FixedFrontSink& sink) {
  TriangleRaster raster(view);
  const Wanted wanted = Wanted::all_of(view);
  return view.turning()
             ? draw_faces<true>(layer, view, wanted, 0, layer.num_faces(), 1, raster, sink)
             : draw_faces<false>(layer, view, wanted, 0, layer.num_faces(), 1, raster, sink);
}

void find_doubtful(float upper, MotionDepths& out) {
  out.doubtful.assign(out.size(), 0);
  float nearest = kFloatInfinity;
  for (size_t i = 0; i < out.size(); ++i) {
    if (!out.has_both(i)) continue;
    ++out.num_pixels;
    const float gap = out.gap(i);
    // Only pixels within the bound can hold the first contact.
    if (!(gap <= upper)) continue;
    out.doubtful[i] = 1;
    ++out.num_doubtful;
    nearest = std::min(nearest, gap);
  }
  // One float32 ulp for the subtraction of depths.
  if (nearest < kFloatInfinity) out.lower = out.frame.time_before(nearest * (1 - 2e-7));
}

}  // namespace

float MotionDepths::gap(size_t pixel) const {
  return std::max(0.0F, fixed_front[pixel] - moving_front[pixel]);
}

double MotionDepths::shown(double depth) const {
  return turns() ? depth * 180 / kPi : 1e3 * frame.pixel * depth;
}

std::optional<size_t> MotionDepths::pixel_of(const Vec3& world) const {
  if (frame.empty()) return std::nullopt;
  // The point is projected as a vertex would be.
  const Vec3 p = frame.image_from_world * (world - frame.origin) / frame.pixel;
  const double column = turns() ? p.head<2>().norm() - frame.first_radius : p.x();
  const double row = turns() ? p.z() : p.y();
  if (!(column >= 0 && column < frame.width && row >= 0 && row < frame.height)) return std::nullopt;
  return static_cast<size_t>(row) * frame.width + static_cast<size_t>(column);
}

MotionDepths motion_depths(const FirstContactQuery& query, double horizon, int resolution) {
  MotionDepths out;
  out.frame = make_zlist_frame(query, horizon, resolution);
  if (out.frame.empty()) return out;
  // Moving faces come first, as they tell which fixed ones lie behind.
  Layer moving(out.frame, query.moving, out.frame.moving);
  Layer fixed(out.frame, query.fixed, out.frame.fixed);
  moving.project(1);
  fixed.project(1);
  DepthMap map;
  out.complete = draw_depth_map(moving, View::whole(out.frame, true), 1, map);
  out.fixed_front.assign(map.upper.size(), kFloatInfinity);
  // Times beyond the horizon do not count.
  SharedMinimum upper;
  const float reach = rounded_up(std::min(out.frame.reach, 1e30));
  upper.reset(reach);
  FixedFrontSink sink(map, upper, out.fixed_front);
  out.complete &= draw_fixed(fixed, View::whole(out.frame, false), sink);
  out.moving_front = std::move(map.upper);
  find_doubtful(upper.get(), out);
  if (upper.get() < out.frame.reach) out.upper = out.frame.time_after(upper.get());
  return out;
}

}  // namespace trivet
