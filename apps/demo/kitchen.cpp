// KITCHEN: a unit with drawers and doors that are opened, filled and closed; one of each stays
// ajar. The unit's middle is above the origin; who works at it stands at -y.
#include "apps/demo/layout_writer.h"
#include "apps/demo/layouts.h"
#include "apps/demo/shapes/models.h"

namespace trivet {
namespace {

using shapes::kDrawerFloor;
using shapes::kKitchenBoards;
using shapes::kWorktopHeight;

constexpr double kFrontFace = -0.290, kDrawers = -0.300;  // y of the fronts, x of the drawers
constexpr double kDeep = 0.090, kShallow = 0.458, kCutlery = 0.702;  // their undersides
constexpr double kOpen = 0.40, kAjar = 0.36;                         // of drawers

NamedJoint slide_out() {
  NamedJoint out{"unit", {}};
  out.joint.kind = LinkJoint::Kind::Slide;
  out.joint.axis = -Vec3::UnitY();
  out.joint.lower = 0;
  out.joint.upper = 0.42;
  return out;
}

// @param axis  about which the door opens, upwards or downwards.
NamedJoint hinge(double axis) {
  NamedJoint out{"unit", {}};
  out.joint.kind = LinkJoint::Kind::Hinge;
  out.joint.axis = Vec3(0, 0, axis);
  out.joint.lower = 0;
  out.joint.upper = 110;
  return out;
}

void hang_fronts(LayoutWriter& w) {
  const auto hang_drawer = [&](const char* name, const char* model, double z) {
    w.hang(name, model, Vec3(kDrawers, kFrontFace, z), slide_out());
  };
  hang_drawer("cutlery_drawer", "cutlery_drawer", kCutlery);
  hang_drawer("middle_drawer", "drawer_shallow", kShallow);
  hang_drawer("low_drawer", "drawer_deep", kDeep);
  w.hang("left_door", "door_left", Vec3(0.002, kFrontFace, kDeep), hinge(-1));
  w.hang("right_door", "door_right", Vec3(0.598, kFrontFace, kDeep), hinge(1));
}

// @param y  behind the front's face. @param opened  how far the drawer is out.
Vec3 in_drawer(double drawer, double x, double y, double opened, double by = 0.02) {
  return {kDrawers + x, kFrontFace - opened + y, drawer + kDrawerFloor + by};
}

void fill_cutlery_drawer(LayoutWriter& w) {
  w.move_joint("cutlery_drawer", kOpen);
  constexpr double kSpoons[] = {-0.022, 0.022, 0};  // the third on the others
  for (int i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i + 1);
    const double y = 0.15 + 0.012 * i;
    w.put("knife_" + number, "knife", in_drawer(kCutlery, -0.126 + 0.026 * i, y, kOpen),
          about_z(87 + 3 * i));
    w.put("spoon_" + number, "spoon", in_drawer(kCutlery, kSpoons[i], y, kOpen, 0.02 + 0.01 * i),
          about_z(90 + 60 * kSpoons[i]));
  }
  w.put("screwdriver", "screwdriver", in_drawer(kCutlery, 0.20, 0.14, kOpen), about_z(96));
  w.put("pencil", "pencil", in_drawer(kCutlery, 0.10, 0.15, kOpen), about_z(84));
  for (int i = 0; i < 2; ++i)
    w.put("soap_" + std::to_string(i + 1), "soap",
          in_drawer(kCutlery, -0.14 + 0.12 * i, 0.39, kOpen), about_z(4 - 10 * i));
  w.move_joint("cutlery_drawer", kAjar);
}

void fill_other_drawers(LayoutWriter& w) {
  w.move_joint("middle_drawer", kOpen);
  for (int i = 0; i < 4; ++i)
    w.put("can_" + std::to_string(i + 1), i % 2 ? "can_green" : "can_red",
          in_drawer(kShallow, -0.17 + 0.10 * i, 0.14 + 0.03 * (i % 2), kOpen));
  w.move_joint("middle_drawer", 0);
  w.move_joint("low_drawer", kOpen);
  for (int i = 0; i < 2; ++i)
    w.put("cereal_" + std::to_string(i + 1), "cereal",
          in_drawer(kDeep, -0.12 + 0.21 * i, 0.16, kOpen), about_z(i ? -4 : 3));
  w.move_joint("low_drawer", 0);
}

Vec3 on_board(int board, double x, double y, double by = 0.02) {
  return {x, y, kKitchenBoards[board] + by};
}

void fill_cupboard(LayoutWriter& w) {
  w.move_joint("left_door", 95);
  w.move_joint("right_door", 105);
  for (int i = 0; i < 5; ++i)
    w.put("plate_" + std::to_string(i + 1), "plate", on_board(1, 0.44, -0.10, 0.02 + 0.02 * i),
          about_z(7 * i));
  for (int i = 0; i < 2; ++i)
    w.put("cup_" + std::to_string(i + 1), "cup", on_board(1, 0.10 + 0.12 * i, -0.13 + 0.1 * i),
          about_z(-60 + 40 * i));
  for (int i = 0; i < 3; ++i)
    w.put("bottle_" + std::to_string(i + 1), "bottle", on_board(0, 0.36 + 0.09 * i, -0.12));
  w.put("jar_1", "jar", on_board(0, 0.15, -0.12));
  w.put("carton", "carton", on_board(0, 0.25, -0.05), about_z(8));
  w.move_joint("left_door", 0);
  w.move_joint("right_door", 98);
}

Vec3 on_top(double x, double y, double by = 0.03) { return {x, y, kWorktopHeight + by}; }

void put_on_worktop(LayoutWriter& w) {
  w.put("board", "chopping_board", on_top(0.24, -0.12), about_z(-6));
  w.put("loaf", "loaf", on_top(0.20, -0.10, 0.06), about_z(20));
  w.put("bread_knife", "knife", on_top(0.33, -0.17, 0.06), about_z(75));
  w.put("toast", "toast", on_top(0.02, -0.19), about_z(-10));
  w.put("bowl", "bowl", on_top(-0.17, 0.02));
  w.put("apple_1", "apple", on_top(-0.13, 0.02, 0.08), about_z(15));
  w.put("apple_2", "apple", on_top(-0.20, 0.06, 0.08), about_z(140));
  w.put("apple_3", "apple", on_top(-0.20, -0.03, 0.08), about_z(265));
  w.put("teapot", "teapot", on_top(-0.43, 0.08), about_z(200));
  w.put("mug", "mug", on_top(-0.46, -0.13), about_z(-50));
  for (int i = 0; i < 3; ++i)
    w.put("jar_" + std::to_string(i + 2), "jar", on_top(0.18 + 0.09 * i, 0.22));
  w.put("bottle_4", "bottle", on_top(0.50, 0.20));
}

}  // namespace

DemoLayout make_kitchen() {
  LayoutWriter w("kitchen");
  w.look({Vec3(-0.82, -2.02, 2.30), Vec3(0.045, -0.17, 0.65), 35});
  w.fix("wall", "wall", Vec3(0, 0.37, shapes::kGrid));
  w.fix("unit", "kitchen_unit");
  hang_fronts(w);
  fill_cupboard(w);
  fill_other_drawers(w);
  fill_cutlery_drawer(w);
  put_on_worktop(w);
  return w.take();
}

}  // namespace trivet
