// Bending of cotton: a bending length of 19 mm, in the middle of what ISO 9073-7 and ASTM D1388
// tests of plain shirting give, so that B = weight per area x 19 mm^3. Paper of 80 g/m2: Young's
// modulus of 3 GPa over a thickness of 0.1 mm: E t, and E t^3 / 12. Others are estimates from
// handling: weights per area as shops state them; stiffness so that the bending length is what a
// strip over a table's edge shows (wool 24 mm, towel 23 mm, felt 60 mm). Flexible lead: two cores
// of 0.75 mm2 in PVC (IEC 60227, 60227 IEC 52), 0.04 kg/m and 6 mm by makers' tables; bending by a
// strip of it over an edge. Friction: of each on dry wood.
#include "core/flex/presets.h"

namespace trivet::flex {
namespace {

constexpr float kDark[3] = {0.02f, 0.02f, 0.022f};

FlexPreset sheet(const char* name, double density, double thickness, double stretch, double shear,
                 double bending, double friction, const float (&colour)[3]) {
  FlexPreset out{{name, density, thickness, stretch, 0.2 * stretch, shear, bending, 0.8, friction},
                 false,
                 {colour[0], colour[1], colour[2]}};
  return out;
}

FlexPreset cable(const char* name, double density, double diameter, double stretch, double bending,
                 double friction) {
  return {{name, density, diameter, stretch, 0, 0, bending, 1, friction},
          true,
          {kDark[0], kDark[1], kDark[2]}};
}

}  // namespace

std::span<const FlexPreset> flex_presets() {
  static const FlexPreset kAll[] = {
      sheet("cotton", 0.15, 5e-4, 1000, 50, 1e-5, 0.4, {0.72f, 0.70f, 0.66f}),
      sheet("felt", 0.5, 3e-3, 2000, 200, 1e-3, 0.5, {0.16f, 0.22f, 0.14f}),
      cable("lead", 0.04, 6e-3, 5000, 2e-4, 0.4),
      sheet("paper", 0.08, 1e-4, 3e5, 1e5, 2.5e-4, 0.3, {0.8f, 0.8f, 0.79f}),
      sheet("towel", 0.4, 2e-3, 500, 30, 5e-5, 0.6, {0.18f, 0.33f, 0.45f}),
      sheet("wool", 0.3, 1.5e-3, 500, 30, 4e-5, 0.5, {0.30f, 0.08f, 0.06f}),
  };
  return kAll;
}

const FlexPreset* flex_preset(const std::string& name) {
  for (const FlexPreset& preset : flex_presets())
    if (preset.material.name == name) return &preset;
  return nullptr;
}

}  // namespace trivet::flex
