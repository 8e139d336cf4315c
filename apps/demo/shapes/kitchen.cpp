// A kitchen unit with its drawers and doors, and a chopping board. Fronts are at -y.
#include <algorithm>
#include <cmath>

#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/palette.h"
#include "apps/demo/shapes/parts.h"

namespace trivet::shapes {
namespace {

constexpr double kKitchenOverlap = 0.001;  // how deep parts go into each other
constexpr double kFrontThickness = 0.018, kBevel = 0.002, kDoorHeight = 0.762;

Material oak() { return make_material("oak", 0.47f, 0.28f, 0.13f, 0.45f); }
Material lacquer() { return make_material("green lacquer", 0.12f, 0.20f, 0.155f, 0.45f); }
Material brass() { return make_material("brass", 0.62f, 0.44f, 0.19f, 0.3f, 1.0f); }
Material white_board() { return make_material("white board", 0.74f, 0.72f, 0.67f, 0.6f); }

// A wall of tiles behind the worktop, with grooves between them.
void add_tiles(Index tile, Index grout, std::vector<Part>* parts) {
  constexpr int kColumns = 8, kRows = 4;
  constexpr double kPitch = 0.155, kHeight = 0.100, kGroove = 0.003, kFace = 0.285;
  const double left = -0.5 * kColumns * kPitch, low = kWorktopHeight;
  add_box({left, kFace + 0.004, low - 0.005}, {-left, 0.300, low + kRows * kHeight}, 0, grout,
          parts);
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const double x = left + column * kPitch, z = low + row * kHeight;
      add_box(
          {x + kGroove / 2, kFace, z + kGroove / 2},
          {x + kPitch - kGroove / 2, kFace + 0.004 + kKitchenOverlap, z + kHeight - kGroove / 2},
          0.001, tile, parts);
    }
}

// A bow on a front whose face is at y = 0.
Part bow(const Vec2& at, bool upright, Index material) {
  Surface surface = bow_handle(upright ? 0.080 : 0.095);
  if (upright) surface = turned(surface, Vec3::UnitY(), 90);
  return {painted(moved(surface, {at.x(), 0, at.y()}), material), 60};
}

// Bottom, sides and back behind a front, which is lower than the drawer's place is high.
struct Drawer {
  double front_height, side_height;
};

constexpr Index kLacquer = 0, kBrass = 1, kWhite = 2;
constexpr double kDrawerHalfWidth = 0.270, kDrawerBack = 0.480, kDrawerSide = 0.012;

std::vector<Part> drawer_parts(const Drawer& drawer) {
  const double w = kDrawerHalfWidth, high = drawer.side_height, under = kDrawerFloor - kDrawerSide;
  std::vector<Part> parts;
  add_box({-0.298, 0, 0}, {0.298, kFrontThickness, drawer.front_height}, kBevel, kLacquer, &parts);
  const double front = kFrontThickness - kKitchenOverlap;
  add_box({-w + kKitchenOverlap, front, under},
          {w - kKitchenOverlap, kDrawerBack - kKitchenOverlap, kDrawerFloor}, 0, kWhite, &parts);
  for (const double s : {-1.0, 1.0})
    add_box({std::min(s * w, s * (w - kDrawerSide)), front, under},
            {std::max(s * w, s * (w - kDrawerSide)), kDrawerBack, high}, 0.001, kWhite, &parts);
  const double between = w - kDrawerSide + kKitchenOverlap;
  add_box({-between, kDrawerBack - kDrawerSide, under},
          {between, kDrawerBack - kKitchenOverlap / 2, high - 0.001}, 0, kWhite, &parts);
  parts.push_back(bow({0, drawer.front_height - 0.060}, false, kBrass));
  return parts;
}

Model make_drawer(const std::string& name, const std::vector<Part>& parts) {
  return assemble(name, parts, {lacquer(), brass(), white_board(), oak()});
}

// The hinge is at the origin; `side` -1: the door hangs at its left.
Model make_door(const std::string& name, double side) {
  const double outer = -side * kDoorWidth;
  std::vector<Part> parts;
  add_box({std::min(0.0, outer), 0, 0}, {std::max(0.0, outer), kFrontThickness, kDoorHeight},
          kBevel, kLacquer, &parts);
  parts.push_back(bow({outer + side * 0.035, kDoorHeight - 0.150}, true, kBrass));
  return assemble(name, parts, {lacquer(), brass()});
}

}  // namespace

Model make_kitchen_unit() {
  constexpr Index kBoard = 0, kTop = 1, kPlinth = 2, kTile = 3, kGrout = 4;
  const double front = -0.270, back = 0.280, under = kWorktopHeight - 0.040;
  std::vector<Part> parts;
  for (const double x : {-0.591, 0.009, 0.591})
    add_box({x - 0.009, front, 0.080}, {x + 0.009, back, under + kKitchenOverlap}, 0.001, kBoard,
            &parts);
  add_box({-0.590, front + kKitchenOverlap, 0.082},
          {0.590, back - kKitchenOverlap, kKitchenBoards[0]}, 0, kBoard, &parts);
  add_box({0.017, front + 0.020, kKitchenBoards[1] - 0.018}, {0.583, back, kKitchenBoards[1]},
          0.001, kBoard, &parts);
  add_box({-0.583, back - 0.010, 0.090},
          {0.583, back - kKitchenOverlap, under + kKitchenOverlap / 2}, 0, kBoard, &parts);
  add_box({-0.570, -0.230, 0}, {0.570, 0.250, 0.084}, 0, kPlinth, &parts);
  const Surface top = skin(slab({0.620, 0.305}, 0.010, 0.004, under, kWorktopHeight, 3));
  parts.push_back({painted(moved(top, {0, -0.005, 0}), kTop), 40});
  add_tiles(kTile, kGrout, &parts);
  return assemble("kitchen_unit", parts,
                  {white_board(), oak(), make_material("plinth", 0.10f, 0.10f, 0.10f, 0.7f),
                   make_material("tile", 0.80f, 0.79f, 0.74f, 0.12f),
                   make_material("grout", 0.45f, 0.44f, 0.41f, 0.9f)});
}

// With compartments along and across.
Model make_cutlery_drawer() {
  constexpr Index kTray = 3;
  std::vector<Part> parts = drawer_parts({0.150, 0.105});
  const double half = kDrawerHalfWidth - kDrawerSide + kKitchenOverlap,
               low = kDrawerFloor - kKitchenOverlap, high = 0.065;
  add_box({-half, 0.300, low}, {half, 0.308, high}, 0.001, kTray, &parts);
  for (const double x : {-0.150, -0.050, 0.050, 0.150})
    add_box({x - 0.004, kFrontThickness - kKitchenOverlap, low},
            {x + 0.004, 0.301, high - kKitchenOverlap}, 0.001, kTray, &parts);
  return make_drawer("cutlery_drawer", parts);
}

Model make_drawer_shallow() { return make_drawer("drawer_shallow", drawer_parts({0.240, 0.180})); }
Model make_drawer_deep() { return make_drawer("drawer_deep", drawer_parts({0.364, 0.270})); }

Model make_door_left() { return make_door("door_left", -1); }
Model make_door_right() { return make_door("door_right", 1); }

Model make_chopping_board() {
  return assemble("chopping_board", {{skin(slab({0.180, 0.120}, 0.020, 0.004, 0, 0.018, 5)), 40}},
                  {make_material("beech", 0.58f, 0.37f, 0.19f, 0.6f)});
}

}  // namespace trivet::shapes
