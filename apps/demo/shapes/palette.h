// Colours that the models share; linear RGB.
#pragma once

#include "apps/demo/shapes/assemble.h"

namespace trivet::shapes {

inline Material porcelain() { return make_material("porcelain", 0.86f, 0.85f, 0.81f, 0.15f); }
inline Material cobalt() { return make_material("cobalt", 0.05f, 0.12f, 0.42f, 0.15f); }
inline Material stoneware() { return make_material("stoneware", 0.16f, 0.36f, 0.36f, 0.3f); }
inline Material stoneware_rim() {
  return make_material("stoneware rim", 0.62f, 0.55f, 0.38f, 0.3f);
}
inline Material silver() { return make_material("silver", 0.82f, 0.82f, 0.80f, 0.2f, 1.0f); }
inline Material clear_glass() {
  Material glass = make_material("glass", 0.80f, 0.92f, 0.90f, 0.05f);
  glass.base_colour[3] = 0.2f;
  return glass;
}
inline Material orange_juice() { return make_material("orange juice", 0.95f, 0.42f, 0.03f, 0.2f); }
inline Material tea() { return make_material("tea", 0.28f, 0.08f, 0.01f, 0.1f); }
inline Material milk() { return make_material("milk", 0.90f, 0.87f, 0.78f, 0.2f); }
inline Material dark_wood() { return make_material("dark wood", 0.09f, 0.035f, 0.015f, 0.5f); }
inline Material black_plastic() {
  return make_material("black plastic", 0.022f, 0.023f, 0.026f, 0.45f);
}
inline Material white_paper() { return make_material("paper", 0.84f, 0.83f, 0.79f, 0.8f); }

}  // namespace trivet::shapes
