// The models of the demos, made from smooth curves. Metres, z up, the lowest point at z = 0; what
// stands upright has its axis through the origin. Handles point to +x; what belongs to an office
// has its front at -y.
#pragma once

#include <string>
#include <vector>

#include "core/model/model.h"

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

Model make_table();       // with a cloth; its top face at kTableHeight, the cloth's at kClothHeight
Model make_bare_table();  // the same without
Model make_pegs();        // three on a wall, at kPegHeight, towards -y

Model make_desk();      // its top at kDeskHeight; a person sits at -y
Model make_bookcase();  // open to -y, boards at kBookcaseBoards
Model make_chair();     // with castors; its back at +y

Model make_monitor();
Model make_keyboard();
Model make_mouse();
Model make_telephone();
Model make_lamp();  // its shade is at +x

Model make_book_red();
Model make_book_blue();
Model make_book_green();
Model make_book_yellow();
Model make_binder();
Model make_letter();      // a sheet of A4, one corner bent up
Model make_report();      // some more sheets
Model make_paper_ball();  // a crumpled sheet

Model make_mug();     // empty
Model make_pencil();  // lies along x, its tip at +x
Model make_pen();     // lies along x, its tip at +x
Model make_waste_basket();
Model make_plant();

Model make_wall();  // 3.2 m along x

Model make_shop_shelf();  // open to -y, boards at kShopBoards
Model make_can_red();
Model make_can_green();
Model make_tin();
Model make_carton();
Model make_cereal();
Model make_soap();
Model make_jar();
Model make_bottle();

Model make_workbench();  // its top at kBenchHeight, a board below
Model make_parts_bin();
Model make_bolt();  // lies along x
Model make_nut();
Model make_bracket();
Model make_hammer();       // lies along x, its head at -x
Model make_screwdriver();  // lies along x, its tip at +x
Model make_toolbox();

Model make_kitchen_unit();    // open to -y, boards at kKitchenBoards, its top at kWorktopHeight
Model make_cutlery_drawer();  // drawers: their fronts' faces at y = 0, above kDrawerFloor
Model make_drawer_shallow();
Model make_drawer_deep();
Model make_door_left();  // doors: hinged at the z axis, kDoorWidth wide
Model make_door_right();
Model make_chopping_board();

inline constexpr double kTableHeight = 0.74;
inline constexpr double kClothHeight = 0.7415;
inline constexpr double kPegHeight = 1.5;
inline constexpr double kDeskHeight = 0.73;
inline constexpr double kBookcaseHeight = 1.19;
inline constexpr double kBookcaseBoards[] = {0.08, 0.45, 0.82};  // the upper sides
inline constexpr double kShopBoards[] = {0.12, 0.47, 0.82, 1.14, 1.46};
inline constexpr double kBenchHeight = 0.88;
inline constexpr double kWorktopHeight = 0.90;
inline constexpr double kKitchenBoards[] = {0.100, 0.480};
inline constexpr double kDrawerFloor = 0.026;
inline constexpr double kDoorWidth = 0.296;

/// All of the above by name: "saucer", "plate", ..., "plant".
std::vector<std::string> model_names();
/// @throws Error (BadInput) when there is no model of that name.
Model make_model(const std::string& name);

}  // namespace trivet::shapes
