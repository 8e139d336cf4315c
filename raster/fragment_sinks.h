// What the passes of a search do with what is drawn. Private.
#pragma once

#include "raster/zlist_search.h"

namespace trivet {

/// Fixed faces against the depth map of the moving ones: keeps what may be first, lowers the bound.
class FixedSink final : public SpanSink {
 public:
  static constexpr bool kCentres = true;
  FixedSink(const DepthMap& map, SharedMinimum& upper) : m_map(map), m_upper(upper) {}

  bool keep = true;  // false: only the upper bound is wanted
  std::vector<Fragment> found;
  std::vector<char> covered;  // pixels that both sides touch; empty: not asked for
  std::size_t most = 0;       // fragments
  bool overflow = false;

  // The line through the centre meets both: they touch when it says, unless they have before.
  void sample(int pixel, float centre, float error) {
    const float moving = m_map.highest_centre[pixel];
    const bool certainly_ahead = centre - error >= moving + 2 * kLargestCentreError;
    if (certainly_ahead) m_upper.lower_to((centre + error - moving) * 1.000001F);
  }

  void span(const Span& s) override {
    const int at = s.row * m_map.width + s.first;
    if (keep)
      for (int i = 0; i < s.count; ++i) add(at + i, face, s.lower[i], s.upper[i]);
    if (s.centre_error <= kLargestCentreError)
      for (int i = 0; i < s.count; ++i) sample(at + i, s.centre[i], s.centre_error);
  }

  void small(const SmallFace& f) {
    if (!keep) return;
    for (int y = f.y0; y <= f.y1; ++y)
      for (int x = f.x0; x <= f.x1; ++x) add(y * m_map.width + x, f.face, f.lower, f.upper);
  }

  /// Drops what the bound has left behind since.
  void compact() {
    const float upper = m_upper.get();
    std::erase_if(found, [&](const Fragment& f) { return f.lower - m_map.upper[f.pixel] > upper; });
  }

 private:
  void add(int pixel, std::uint32_t id, float lower, float upper) {
    const float front = m_map.upper[pixel];
    // Nothing moving there (front is -infinity), or behind its rear: it moves away.
    if (!(upper >= m_map.lower[pixel]) || !(lower <= upper)) return;
    if (!covered.empty()) covered[pixel] = 1;
    if (!(lower - front <= m_upper.get())) return;
    if (found.size() >= most) {
      compact();
      if (found.size() >= most / 2) overflow = true;
      if (overflow) return;
    }
    found.push_back({pixel, id, lower, upper});
  }

  const DepthMap& m_map;
  SharedMinimum& m_upper;
};

/// Moving faces in the pixels where fixed ones are left.
class MovingSink final : public SpanSink {
 public:
  static constexpr bool kCentres = false;
  struct Limits {
    std::vector<float> lower, upper;  // per pixel: a moving face must reach this, begin before that
  };
  explicit MovingSink(const Limits& limits, int width) : m_limits(limits), m_width(width) {}

  std::vector<Fragment> found;
  std::size_t most = 0;
  bool overflow = false;

  void span(const Span& s) override {
    const int at = s.row * m_width + s.first;
    for (int i = 0; i < s.count; ++i) add(at + i, face, s.lower[i], s.upper[i]);
  }
  void small(const SmallFace& f) {
    for (int y = f.y0; y <= f.y1; ++y)
      for (int x = f.x0; x <= f.x1; ++x) add(y * m_width + x, f.face, f.lower, f.upper);
  }

 private:
  void add(int pixel, std::uint32_t id, float lower, float upper) {
    if (!(upper >= m_limits.lower[pixel]) || !(lower <= m_limits.upper[pixel]) || lower > upper)
      return;
    if (found.size() < most)
      found.push_back({pixel, id, lower, upper});
    else
      overflow = true;
  }

  const Limits& m_limits;
  int m_width;
};

/// Keeps everything, and the map: of few faces, in a zoomed view.
class ZoomSink final : public SpanSink {
 public:
  ZoomSink(DepthMap& map, std::vector<Fragment>& found) : m_map(map), m_found(found) {}
  void span(const Span& s) override {
    m_map.add(s);
    for (int i = 0; i < s.count; ++i)
      if (s.lower[i] <= s.upper[i])
        m_found.push_back({s.row * m_map.width + s.first + i, face, s.lower[i], s.upper[i]});
  }

 private:
  DepthMap& m_map;
  std::vector<Fragment>& m_found;
};

}  // namespace trivet
