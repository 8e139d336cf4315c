// Light, floor and camera of a scene's pictures, drawn from the recipe's ranges.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "apps/farm/recipe/decisions.h"
#include "apps/farm/recipe/look.h"
#include "core/io/textures/texture_image.h"
#include "raster/path/environment.h"
#include "raster/path/picture.h"

namespace trivet::farm {

/// Images by their names in the recipe, each read once in a process.
class LookImages {
 public:
  /// @param file_of  name in the recipe -> where it is read.
  explicit LookImages(std::map<std::string, std::string> file_of) : m_file_of(std::move(file_of)) {}
  /// @throws Error (BadInput) naming the file.
  std::shared_ptr<const EnvironmentMap> environment(const std::string& name);
  std::shared_ptr<const TextureImage> texture(const std::string& name);

 private:
  template <class Image, class Decode>
  std::shared_ptr<const Image> get(std::map<std::string, std::shared_ptr<const Image>>& known,
                                   const std::string& name, const Decode& decode) const;

  std::map<std::string, std::string> m_file_of;
  std::map<std::string, std::shared_ptr<const EnvironmentMap>> m_environments;
  std::map<std::string, std::shared_ptr<const TextureImage>> m_textures;
};

/// The look of view number `view` of scene k: light and floor are those of the scene.
PictureLook look_of(const LookRanges& ranges, LookImages& images, const PhiloxKey& key,
                    std::uint64_t k, int view);

/// Linear, of sRGB components between the ends.
std::array<float, 3> colour_within(const ColourRange& range, Decision decision);

/// Colour of a black body beside that of 6500 K, linear RGB, of luminance 1. @see [Krystek 1985]
Vec3 colour_of_temperature(double kelvin);

}  // namespace trivet::farm
