// A picture with text and colour scales, without a graphics library.
#pragma once

#include <string>

#include "core/base/image.h"
#include "raster/zlist/depth_picture.h"

namespace trivet::apps {

/// White at first. Coordinates in pixels from above left; what is outside is cut off.
class Canvas {
 public:
  static constexpr int kBarHeight = 12, kMargin = 6, kTextHeight = 14;
  static constexpr int kScaleHeight = kBarHeight + kMargin + kTextHeight;
  static constexpr Rgb kBlack{0, 0, 0};

  Canvas(int width, int height);
  Image take() { return std::move(m_image); }

  void set(int x, int y, const Rgb& colour);
  void fill(int x0, int y0, int width, int height, const Rgb& colour);
  /// Only digits, "+-." and the letters of "moving front", "fixed", "gap", "deg" and "m" are drawn.
  void write(int x, int y, const std::string& text);
  static int width_of(const std::string& text);
  /// scale_colour() with numbers below it, at both ends and in the middle.
  /// @param open  some values are beyond `high`.
  void draw_scale(int x, int y, int width, double low, double high, const std::string& unit,
                  bool open);

 private:
  Image m_image;
};

}  // namespace trivet::apps
