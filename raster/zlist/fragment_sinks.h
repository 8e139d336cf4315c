// Sinks for the passes of a search. Private.
#pragma once

#include "raster/zlist/search.h"

namespace trivet {

/// Tests fixed faces against the depth map of the moving ones: keeps candidates, lowers the bound.
class FixedSink final : public SpanSink {
 public:
  static constexpr bool kCentres = true;
  FixedSink(const DepthMap& map, SharedMinimum& upper) : m_map(map), m_upper(upper) {}

  bool keep = true;  // false: only the upper bound is needed
  std::vector<Fragment> found;
  std::vector<char> covered;  // pixels touched by both sides; empty: not needed
  std::size_t most = 0;       // fragments
  bool overflow = false;

  // The line through the centre meets both: contact at that time at the latest.
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

  /// Drops fragments beyond the lowered bound.
  void compact() {
    const float upper = m_upper.get();
    std::erase_if(found, [&](const Fragment& f) { return f.lower - m_map.upper[f.pixel] > upper; });
  }

 private:
  void add(int pixel, std::uint32_t id, float lower, float upper) {
    const float front = m_map.upper[pixel];
    // No moving face there (front is -infinity), or behind its rear: separating.
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
    std::vector<float> lower,
        upper;  // per pixel: a moving face must reach one and begin before the other
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

/// Moving faces in the pixels of a mask; the map is that of all pixels.
class MaskedSink final : public SpanSink {
 public:
  static constexpr bool kCentres = true;
  MaskedSink(const std::vector<char>& mask, const View& view)
      : map(view.width, view.height), m_mask(mask) {}

  DepthMap map;
  std::vector<Fragment> found;
  std::size_t most = 0;
  bool overflow = false;

  void span(const Span& s) override {
    map.add(s);
    const int at = s.row * map.width + s.first;
    for (int i = 0; i < s.count; ++i)
      if (s.lower[i] <= s.upper[i]) add(at + i, face, s.lower[i], s.upper[i]);
  }
  void small(const SmallFace& f) {
    map.add(f);
    for (int y = f.y0; y <= f.y1; ++y)
      for (int x = f.x0; x <= f.x1; ++x) add(y * map.width + x, f.face, f.lower, f.upper);
  }
  void sample(int pixel, float depth, float error) { map.add_sample(pixel, depth, error); }

 private:
  void add(int pixel, std::uint32_t id, float lower, float upper) {
    if (!m_mask[pixel]) return;
    if (found.size() < most)
      found.push_back({pixel, id, lower, upper});
    else
      overflow = true;
  }

  const std::vector<char>& m_mask;
};

/// Keeps all fragments, and the map: for few faces, in a zoomed view.
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
