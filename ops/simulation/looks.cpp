#include "ops/simulation/looks.h"

#include <algorithm>
#include <map>
#include <mutex>

#include "core/picture/base_colours.h"

namespace trivet {
namespace {

/// Notes on all that a model has beside images of base colours.
void note_what_is_left_out(const Model& model, const SurfaceLook& look, SimulationLook& out) {
  const auto any = [&](auto has) {
    return std::any_of(look.finishes.begin(), look.finishes.end(), has);
  };
  const auto note = [&](bool is_left_out, const char* text) {
    if (is_left_out) out.left_out.push_back(say(text, model.path));
  };
  note(any([](const SurfaceFinish& f) { return bool(f.normal); }),
       TRIVET_SENTENCE("\"%1\": its images of normals are left out; files of simulators get base "
                       "colours alone"));
  note(any([](const SurfaceFinish& f) { return bool(f.metallic_roughness); }),
       TRIVET_SENTENCE("\"%1\": its images of roughness and metal are left out; files of "
                       "simulators get base colours alone"));
  note(any([](const SurfaceFinish& f) { return bool(f.emission); }),
       TRIVET_SENTENCE("\"%1\": its images of light of its own are left out; files of simulators "
                       "get base colours alone"));
  note(!look.colours.empty(), TRIVET_SENTENCE("\"%1\": its colours of vertices are left out; files "
                                              "of simulators get base colours alone"));
}

std::shared_ptr<const SimulationLook> made_look(const Model& model) {
  const std::shared_ptr<const SurfaceLook> look = surface_look(model);
  if (!look) return nullptr;
  auto out = std::make_shared<SimulationLook>();
  note_what_is_left_out(model, *look, *out);
  const bool any = std::any_of(look->finishes.begin(), look->finishes.end(),
                               [](const SurfaceFinish& f) { return bool(f.base_colour); });
  if (!any && out->left_out.empty()) return nullptr;
  out->materials = look->materials;
  out->face_material = look->face_material;
  for (size_t m = 0; m < look->materials.size(); ++m) {
    out->images.emplace_back();
    const SurfaceFinish& finish = look->finishes[m];
    if (!finish.base_colour) continue;
    auto& base = out->materials[m].base_colour;
    out->images.back() =
        base_colour_png(*look->images[static_cast<size_t>(finish.base_colour.image)],
                        {base[0], base[1], base[2]}, finish.transparency == Transparency::None);
    base[0] = base[1] = base[2] = 1;
  }
  for (size_t f = 0; f < look->face_material.size(); ++f) {
    const TextureUse& use = look->finishes[static_cast<size_t>(look->face_material[f])].base_colour;
    auto& corners = out->coordinates.emplace_back();
    corners.fill(Eigen::Vector2f::Zero());
    const auto& given = look->coordinates[static_cast<size_t>(use.set)];
    if (!use || f >= given.size()) continue;
    for (size_t k = 0; k < 3; ++k) corners[k] = upward_coordinates(use, given[f][k]);
  }
  return out;
}

}  // namespace

std::shared_ptr<const SimulationLook> simulation_look(const std::shared_ptr<const Model>& model) {
  using Known = std::map<std::weak_ptr<const Model>, std::shared_ptr<const SimulationLook>,
                         std::owner_less<std::weak_ptr<const Model>>>;
  static std::mutex mutex;
  static Known known;
  const std::lock_guard lock(mutex);
  std::erase_if(known, [](const auto& entry) { return entry.first.expired(); });
  const auto found = known.find(model);
  if (found != known.end()) return found->second;
  return known.emplace(model, made_look(*model)).first->second;
}

}  // namespace trivet
