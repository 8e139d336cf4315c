// Light, floor and camera of a scene's pictures, drawn from the recipe's ranges.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "apps/farm/recipe/look.h"
#include "raster/path/environment.h"
#include "raster/path/picture.h"

namespace trivet::farm {

/// Environments by their names in the recipe, each read once in a process.
class Environments {
 public:
  /// @param file_of  name in the recipe -> where it is read.
  explicit Environments(std::map<std::string, std::string> file_of)
      : m_file_of(std::move(file_of)) {}
  /// @throws Error (BadInput) naming the file.
  std::shared_ptr<const EnvironmentMap> get(const std::string& name);

 private:
  std::map<std::string, std::string> m_file_of;
  std::map<std::string, std::shared_ptr<const EnvironmentMap>> m_read;
};

/// The look of view number `view` of scene k: light and floor are those of the scene.
PictureLook look_of(const LookRanges& ranges, Environments& environments, const PhiloxKey& key,
                    std::uint64_t k, int view);

/// Colour of a black body beside that of 6500 K, linear RGB, of luminance 1. @see [Krystek 1985]
Vec3 colour_of_temperature(double kelvin);

}  // namespace trivet::farm
