// Pictures of the depth images of a motion: colours, scale, and how they are turned for people.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "raster/zlist/motion_depths.h"

namespace trivet {

using Rgb = std::array<std::uint8_t, 3>;

/// Viridis [van der Walt 2015]: perceptually uniform, also in grey and for the colour-blind.
/// @param part  0 to 1; others are clamped.
Rgb scale_colour(double part);

/// Outlines of doubtful pixels: no colour of the scale is near it, and it shows on black and white.
inline constexpr Rgb kDoubtfulColour{255, 64, 40};

enum class DepthShow {
  Moving,  // front of what moves
  Fixed,   // front of what is in the way
  Gap,     // between both
};

/// The images as one sees them along the motion, up as near to the world's z as they are, else to
/// its y; of a turn the radius goes to the right, and the axis up. Pixel (0, 0) is above left.
class DepthPicture {
 public:
  /// @param depths  outlives this.
  explicit DepthPicture(const MotionDepths& depths);

  int width() const { return m_width; }  // in pixels of the images
  int height() const { return m_height; }
  /// Unit, world; of a turn the radial direction at depth 0 and the axis.
  const Vec3& right() const { return m_right; }
  const Vec3& up() const { return m_up; }

  /// Index into the images of `depths`.
  size_t pixel(int x, int y) const;
  /// Where a world point is seen; nullopt: outside.
  std::optional<std::array<int, 2>> seen_at(const Vec3& world) const;
  /// Millimetres or degrees; nullopt: nothing there.
  std::optional<double> value(DepthShow show, int x, int y) const;
  /// Smallest and largest value; nullopt: there is none. Gaps begin at 0.
  std::optional<std::array<double, 2>> range(DepthShow show) const;

  /// RGBA, row by row from above, every pixel a square of `magnify` x `magnify`; transparent where
  /// there is nothing. Doubtful regions are outlined, small squares on both sides of the line.
  std::vector<std::uint8_t> paint(DepthShow show, int magnify) const;

 private:
  void paint_square(int x, int y, int magnify, const Rgb& colour,
                    std::vector<std::uint8_t>& out) const;
  void outline(int x, int y, int magnify, std::vector<std::uint8_t>& out) const;
  bool is_doubtful(int x, int y) const;

  const MotionDepths& m_depths;
  int m_width = 0, m_height = 0;
  bool m_transposed = false, m_flip_column = false, m_flip_row = false;  // from images to picture
  Vec3 m_right = Vec3::UnitX(), m_up = Vec3::UnitZ();
};

}  // namespace trivet
