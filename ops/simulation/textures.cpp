#include "ops/simulation/textures.h"

#include <algorithm>

#include "core/io/textures/surface_look.h"
#include "core/picture/png.h"

namespace trivet {
namespace {

using Corners = std::array<Eigen::Vector2f, 3>;

/// At the texture of a face; files have v up the image.
Corners looked_up(const Corners& corners, const TextureUse& use) {
  Corners out;
  for (size_t k = 0; k < 3; ++k) {
    std::array<float, 2> at{};
    for (size_t r = 0; r < 2; ++r) {
      const std::array<float, 3>& row = use.transform[r];
      at[r] = row[0] * corners[k].x() + row[1] * corners[k].y() + row[2];
    }
    out[k] = {at[0], 1 - at[1]};
  }
  return out;
}

std::string png_of(const TextureImage& image) {
  const DecodedImage& finest = image.levels.front();
  return encode_png({finest.width, finest.height, finest.rgba});
}

ModelTextures textures_of(const SurfaceLook& look) {
  ModelTextures out;
  std::vector<int> file(look.images.size(), -1);  // of out.images
  for (const SurfaceFinish& finish : look.finishes) {
    const int image = finish.base_colour.image;
    if (image >= 0 && file[static_cast<size_t>(image)] < 0) {
      file[static_cast<size_t>(image)] = static_cast<int>(out.images.size());
      out.images.push_back(png_of(*look.images[static_cast<size_t>(image)]));
    }
    out.image_of_material.push_back(image < 0 ? -1 : file[static_cast<size_t>(image)]);
  }
  for (size_t f = 0; f < look.face_material.size(); ++f) {
    const TextureUse& use = look.finishes[static_cast<size_t>(look.face_material[f])].base_colour;
    const std::vector<Corners>& corners = look.coordinates[static_cast<size_t>(use.set)];
    out.coordinates.push_back(
        use && f < corners.size()
            ? looked_up(corners[f], use)
            : Corners{Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()});
  }
  return out;
}

bool has_more(const SurfaceLook& look) {
  return !look.colours.empty() ||
         std::any_of(look.finishes.begin(), look.finishes.end(), [](const SurfaceFinish& f) {
           return f.metallic_roughness || f.normal || f.emission;
         });
}

}  // namespace

void add_textures(SimulationModel& model, std::vector<Sentence>& notes) {
  const std::shared_ptr<const SurfaceLook> look = surface_look(*model.model);
  if (!look) return;
  if (has_more(*look))
    notes.push_back(
        say("\"%1\": only base colours are written; its other maps and vertex colours "
            "are left out",
            model.model->path));
  auto textures = std::make_shared<ModelTextures>(textures_of(*look));
  if (textures->images.empty()) return;
  auto shown = std::make_shared<Model>(*model.model);
  shown->materials = look->materials;
  shown->face_material = look->face_material;
  model.model = std::move(shown);
  model.textures = std::move(textures);
}

}  // namespace trivet
