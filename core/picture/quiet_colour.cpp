#include "core/picture/quiet_colour.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/io/colour.h"

namespace trivet {
namespace {

constexpr int kHues = 12;
constexpr float kLightness[] = {0.60f, 0.67f, 0.74f};
constexpr float kChroma[] = {0.04f, 0.06f};
// Colour that assimp gives OBJ and OFF without materials, sRGB; an exact 0.6 is seldom meant.
constexpr float kGreyOfNoColour = 0.6f;

std::uint64_t hashed(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  hash ^= hash >> 32;  // its low bits differ little between short names
  return hash * 0x9e3779b97f4a7c15u >> 16;
}

// Oklab to linear sRGB. @see [Ottosson 2020]
std::array<float, 3> linear_from_oklab(float lightness, float a, float b) {
  const auto cube = [](float x) { return x * x * x; };
  const float l = cube(lightness + 0.3963377774f * a + 0.2158037573f * b);
  const float m = cube(lightness - 0.1055613458f * a - 0.0638541728f * b);
  const float s = cube(lightness - 0.0894841775f * a - 1.2914855480f * b);
  return {std::clamp(4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s, 0.0f, 1.0f),
          std::clamp(-1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s, 0.0f, 1.0f),
          std::clamp(-0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s, 0.0f, 1.0f)};
}

// The importer's materials of files without any: a grey of any name, white or its own default
// without a name.
bool has_no_colour(const Material& material) {
  const auto is = [&](float value) {
    return std::all_of(material.base_colour.begin(), material.base_colour.begin() + 3,
                       [&](float c) { return std::abs(c - value) < 1e-6f; });
  };
  const bool nameless = material.name.empty() || material.name == "DefaultMaterial";
  return material.base_colour[3] >= 1 && (is(linear_from_srgb(kGreyOfNoColour)) ||
                                          (nameless && (is(1) || is(Material().base_colour[0]))));
}

std::string name_for_colour(const Model& model) {
  std::string stem = std::filesystem::path(model.path).stem().string();
  if (!stem.empty()) return stem;
  const auto& v = model.mesh.vertices;
  return {reinterpret_cast<const char*>(v.data()), v.size() * sizeof(Vec3)};
}

}  // namespace

std::array<float, 3> quiet_colour(std::string_view name) {
  const std::uint64_t hash = hashed(name);
  const float hue = static_cast<float>(hash % kHues) * (2 * std::numbers::pi_v<float> / kHues);
  const float lightness = kLightness[hash / kHues % 3], chroma = kChroma[hash / (3 * kHues) % 2];
  return linear_from_oklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
}

std::shared_ptr<const SurfaceLook> quiet_look(const Model& model) {
  if (!std::all_of(model.materials.begin(), model.materials.end(), has_no_colour)) return nullptr;
  auto look = std::make_shared<SurfaceLook>();
  Material material;
  const std::array<float, 3> colour = quiet_colour(name_for_colour(model));
  std::copy(colour.begin(), colour.end(), material.base_colour.begin());
  look->materials.push_back(material);
  look->face_material.assign(model.mesh.triangles.size(), 0);
  return look;
}

}  // namespace trivet
