#include "ops/files/json/material_json.h"

#include "core/base/limits.h"
#include "core/base/nearest_name.h"
#include "core/scene/materials.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

PhysicsMaterial read_preset(const JsonPlace& place) {
  const std::string name = place.text();
  if (const auto preset = material_preset(name)) return *preset;
  std::string accepted;
  for (const std::string& known : material_names())
    accepted.append(accepted.empty() ? "" : ", ").append(known);
  place.refuse(say("%1, or an object with friction, density and restitution%2", accepted,
                   did_you_mean(name, material_names())));
}

}  // namespace

PhysicsMaterial read_material(const JsonPlace& place) {
  if (!place.value().is_object()) return read_preset(place);
  place.expect_object({}, {"friction", "density", "restitution"});
  PhysicsMaterial material;
  const auto read = [&](const char* key, double lower, double upper, double& out) {
    if (const auto found = place.find(key)) out = found->number(lower, upper);
  };
  read("friction", kMinFriction, kMaxFriction, material.friction);
  read("density", kMinDensity, kMaxDensity, material.density);
  read("restitution", 0, kMaxRestitution, material.restitution);
  return material;
}

Json material_json(const PhysicsMaterial& material) {
  if (is_preset(material)) return material.name;
  return {{"friction", material.friction},
          {"density", material.density},
          {"restitution", material.restitution}};
}

Json whole_material_json(const PhysicsMaterial& material) {
  return {{"name", material.name.empty() ? Json() : Json(material.name)},
          {"friction", material.friction},
          {"density", material.density},
          {"restitution", material.restitution}};
}

void write_material(const char* key, const PhysicsMaterial& material, Json& json) {
  if (!same_material(material, {})) json[key] = material_json(material);
}

}  // namespace trivet
