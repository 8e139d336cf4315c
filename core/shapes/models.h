// The models of the demos, made from smooth curves. Metres, z up, the lowest point at z = 0; what
// stands upright has its axis through the origin. Handles point to +x.
#pragma once

#include <string>
#include <vector>

#include "core/io/model.h"

namespace trivet::shapes {

Model make_saucer();
Model make_plate();
Model make_cup();    // filled with tea
Model make_glass();  // filled with orange juice
Model make_bowl();   // for fruit
Model make_egg_cup();
Model make_teapot();  // spout to -x
Model make_jug();     // filled with milk, lip to -x

Model make_spoon();  // lies along x, its bowl at -x
Model make_knife();  // lies along x, its blade at -x

Model make_apple();
Model make_banana();  // lies on its side, bent about +y
Model make_egg();     // stands on its blunt end
Model make_toast();   // lies flat
Model make_loaf();    // lies along x, cut at +x

Model make_table();  // with a cloth; its top face at kTableHeight, the cloth's at kClothHeight

inline constexpr double kTableHeight = 0.74;
inline constexpr double kClothHeight = 0.7415;

/// All of the above by name: "saucer", "plate", ..., "table".
std::vector<std::string> model_names();
/// @throws Error (BadInput) when there is no model of that name.
Model make_model(const std::string& name);

}  // namespace trivet::shapes
