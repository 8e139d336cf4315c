// A shelf of a shop, and what is on it. Fronts are at -y.
#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/palette.h"
#include "apps/demo/shapes/parts.h"

namespace trivet::shapes {
namespace {

// A tin or can: metal rims, a label between them.
Model make_tin_can(const std::string& name, double radius, double height, const Material& label) {
  constexpr Index kMetal = 0, kLabel = 1;
  const auto profile =
      flatten({corner({0, 0}, kMetal), corner({radius, 0}, kMetal), corner({radius, 0.004}, kLabel),
               corner({radius, height - 0.004}, kMetal), corner({radius, height}, kMetal),
               corner({radius - 0.003, height}, kMetal), corner({radius - 0.003, height - 0.003}),
               corner({0, height - 0.003})},
              0.0005);
  return assemble(name, {{skin(revolve(profile, {24, 24, 0}))}}, {silver(), label});
}

// A box of cardboard with another colour on its front.
Model make_pack(const std::string& name, const Vec3& size, const Material& body,
                const Material& front) {
  const Vec3 half(0.5 * size.x(), 0.5 * size.y(), 0);
  const Surface plain = box(-half, {half.x(), half.y(), size.z()});
  const double edge = -half.y() + 1e-6;
  const Surface painted_front =
      painted(painted(plain, 0), 1, [&](const Vec3& p) { return p.y() < edge; });
  return assemble(name, {{painted_front}}, {body, front});
}

}  // namespace

Model make_shop_shelf() {
  constexpr Index kSteel = 0, kPanel = 1;
  const double half_width = 0.47, side = 0.03, front = -0.20, back = 0.20, high = 1.72;
  std::vector<Part> parts;
  const auto add = [&](const Vec3& lower, const Vec3& upper, Index material) {
    parts.push_back({painted(box(lower, upper), material), 40});
  };
  for (const double s : {-1.0, 1.0}) {
    const double inner = s * (half_width - side), outer = s * half_width;
    add({std::min(inner, outer), front, 0}, {std::max(inner, outer), back, high}, kSteel);
  }
  const double inside = half_width - side + 0.001;
  for (const double height : kShopBoards)
    add({-inside, front + 0.003, height - 0.025}, {inside, back - 0.012, height}, kSteel);
  add({-inside, back - 0.013, 0.02}, {inside, back - 0.003, high - 0.01}, kPanel);
  return assemble("shop_shelf", parts,
                  {make_material("shelf steel", 0.62f, 0.64f, 0.66f, 0.4f),
                   make_material("shelf panel", 0.80f, 0.80f, 0.77f, 0.6f)});
}

Model make_can_red() {
  return make_tin_can("can_red", 0.037, 0.110, make_material("red label", 0.55f, 0.04f, 0.03f));
}
Model make_can_green() {
  return make_tin_can("can_green", 0.037, 0.110, make_material("green label", 0.06f, 0.3f, 0.08f));
}
Model make_tin() {
  return make_tin_can("tin", 0.042, 0.045, make_material("tin label", 0.75f, 0.5f, 0.06f));
}

Model make_carton() {
  return make_pack("carton", {0.070, 0.070, 0.205}, white_paper(),
                   make_material("carton front", 0.10f, 0.25f, 0.60f, 0.5f));
}
Model make_cereal() {
  return make_pack("cereal", {0.190, 0.065, 0.285},
                   make_material("cardboard", 0.55f, 0.38f, 0.20f, 0.8f),
                   make_material("cereal front", 0.85f, 0.45f, 0.05f, 0.5f));
}
Model make_soap() {
  return make_pack("soap", {0.085, 0.055, 0.035}, make_material("soap", 0.60f, 0.72f, 0.62f, 0.5f),
                   make_material("soap front", 0.25f, 0.50f, 0.45f, 0.5f));
}

Model make_jar() {
  constexpr Index kLid = 1;
  const auto profile = flatten(
      {corner({0, 0}), corner({0.030, 0}), smooth({0.0340, 0.0050}), corner({0.0345, 0.0300}),
       corner({0.0345, 0.0780}), smooth({0.0330, 0.0860}), corner({0.0290, 0.0920}, kLid),
       corner({0.0325, 0.0925}, kLid), corner({0.0325, 0.1080}, kLid), corner({0, 0.1080})},
      0.0006);
  return assemble("jar", {{skin(revolve(profile, {24, 24, 0}))}},
                  {make_material("jam", 0.35f, 0.03f, 0.06f, 0.1f), silver()});
}

Model make_bottle() {
  constexpr Index kCap = 1;
  const auto profile =
      flatten({corner({0, 0}), corner({0.0330, 0}), smooth({0.0370, 0.0060}),
               corner({0.0375, 0.0300}), corner({0.0375, 0.1450}), smooth({0.0350, 0.1680}),
               smooth({0.0220, 0.1950}), smooth({0.0140, 0.2150}), corner({0.0135, 0.2350}, kCap),
               corner({0.0150, 0.2355}, kCap), corner({0.0150, 0.2560}, kCap), corner({0, 0.2560})},
              0.0006);
  return assemble("bottle", {{skin(revolve(profile, {24, 16, 0.02}))}},
                  {make_material("bottle", 0.05f, 0.16f, 0.05f, 0.1f),
                   make_material("cap", 0.7f, 0.6f, 0.1f, 0.3f)});
}

}  // namespace trivet::shapes
