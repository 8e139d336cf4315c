#include "core/scene/materials.h"

namespace trivet {

std::span<const PhysicsMaterial> material_presets() {
  // Name, friction, density kg/m^3, restitution on a hard floor. 0: the sources have none.
  static const PhysicsMaterial kPresets[] = {
      // Board of any surface [CTU Code 2014], density [Haynes 2014].
      {"cardboard", 0.5, 690, 0},
      // Glazed: as glass; porcelain [Haynes 2014].
      {"ceramic", 0.4, 2400, 0},
      // Smooth, against sawn wood [CTU Code 2014]; normal weight [EN 1991-1-1].
      {"concrete", 0.55, 2400, 0},
      // Sliding; static 0.9 to 1.0 when clean [Oberg 2012]. Sheets [EN 1991-1-1], marbles [Elert].
      {"glass", 0.4, 2500, 0.66},
      // On ice [Urone 2012]; density [Haynes 2014].
      {"ice", 0.1, 917, 0},
      // Against wood [Oberg 2012]; dry [Haynes 2014].
      {"leather", 0.3, 860, 0},
      // Polystyrene [Oberg 2012], density [Haynes 2014]; hollow balls [Elert].
      {"plastic", 0.5, 1050, 0.69},
      // On dry concrete [Urone 2012]; hard rubber [Haynes 2014], bands in a ball [Elert].
      {"rubber", 1.0, 1190, 0.83},
      // Rough, unpainted [CTU Code 2014]; [EN 1991-1-1], bearing balls [Elert].
      {"steel", 0.4, 7850, 0.6},
      // Basic friction angles of 25 to 35 degrees [Barton 1977]; granite [Haynes 2014].
      {"stone", 0.6, 2700, 0},
      // Sawn, against plywood [CTU Code 2014]; oak and beech [Haynes 2014], balls [Elert].
      {"wood", 0.45, 700, 0.6},
  };
  return kPresets;
}

std::vector<std::string> material_names() {
  std::vector<std::string> out;
  for (const PhysicsMaterial& preset : material_presets()) out.push_back(preset.name);
  return out;
}

std::optional<PhysicsMaterial> material_preset(const std::string& name) {
  for (const PhysicsMaterial& preset : material_presets())
    if (preset.name == name) return preset;
  return std::nullopt;
}

std::optional<double> sheet_thickness(const PhysicsMaterial& material) {
  struct Sheet {
    const char* name;
    double metres;
  };
  // Folding boxes, plates and cups, slabs, panes, a frozen puddle, belts, housings, mats, sheet
  // metal, tiles, boards.
  static constexpr Sheet kSheets[] = {
      {"cardboard", 0.0015}, {"ceramic", 0.005},  {"concrete", 0.06}, {"glass", 0.004},
      {"ice", 0.01},         {"leather", 0.0015}, {"plastic", 0.002}, {"rubber", 0.003},
      {"steel", 0.001},      {"stone", 0.02},     {"wood", 0.015}};
  for (const Sheet& sheet : kSheets)
    if (material.name == sheet.name) return sheet.metres;
  return std::nullopt;
}

bool same_material(const PhysicsMaterial& a, const PhysicsMaterial& b) {
  return a.name == b.name && a.friction == b.friction && a.density == b.density &&
         a.restitution == b.restitution;
}

bool is_preset(const PhysicsMaterial& material) {
  const auto preset = material_preset(material.name);
  return preset && same_material(*preset, material);
}

}  // namespace trivet
