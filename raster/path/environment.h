// Surroundings of a scene as an image of all directions: light and background.
#pragma once

#include <vector>

#include "core/index/instance_rays.h"
#include "core/picture/image_files.h"
#include "raster/path/sampler.h"

namespace trivet {

/// An image of 2:1, in equal steps of azimuth from left to right and of elevation from the zenith
/// down, as Radiance's and Blender's; z is up, the middle of the image is in direction +x.
class EnvironmentMap {
 public:
  /// @throws Error (BadInput) for an image that is not twice as wide as high, or black.
  explicit EnvironmentMap(FloatImage image);

  /// @param direction  unit. @return radiance, linear RGB, between pixels.
  Vec3f radiance(const Vec3f& direction) const;
  /// Mean over all directions.
  const Vec3f& mean() const { return m_mean; }

  /// A direction with a density in proportion to luminance, and the radiance there over the
  /// density: the same numbers draw directions evenly. @see [Pharr 2016] section 14.2.4
  struct Drawn {
    Vec3f direction, weight;
  };
  Drawn draw(Sampler::Pair u) const;

 private:
  Vec3f pixel(int x, int y) const;

  FloatImage m_image;
  Vec3f m_mean = Vec3f::Zero();
  std::vector<float> m_rows;     // sums of weights of rows, ascending to 1
  std::vector<float> m_columns;  // within each row, the same
};

}  // namespace trivet
