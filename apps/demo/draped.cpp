// DESK: paper hangs over its edge, a lamp's lead behind it, a coat over the chair. TOWEL: on a peg.
#include "apps/demo/layout_writer.h"
#include "apps/demo/layouts.h"
#include "apps/demo/shapes/models.h"

namespace trivet {
namespace {

using shapes::kDeskHeight;

Vec3 on_desk(double x, double y, double over = 0.05) { return {x, y, kDeskHeight + over}; }
Rotation turned_by(double angle_deg) { return turned(Vec3::UnitZ(), angle_deg); }

// From the lamp's foot over the desk's far edge to the floor.
DrapeOperation lead() {
  DrapeOperation out;
  out.object = "lead";
  out.path = {on_desk(0.60, 0.318, 0.013), on_desk(0.58, 0.42, 0.07), on_desk(0.40, 0.60, 0.02),
              Vec3(-0.3, 0.75, 0.3)};
  out.pins = {out.path.front()};
  out.held_by = {"lamp"};
  return out;
}

}  // namespace

DemoLayout make_desk_demo() {
  LayoutWriter w("desk");
  w.look({Vec3(-1.70, -2.90, 1.75), Vec3(0.05, -0.35, 0.55), 28});
  w.put("desk", "desk", Vec3(0, 0, 0.05));
  w.put("chair", "chair", Vec3(-0.30, -1.05, 0.05), turned_by(200));
  w.put("lamp", "lamp", on_desk(0.60, 0.22), turned_by(150));
  w.put("keyboard", "keyboard", on_desk(-0.15, -0.20));
  w.put("mug", "mug", on_desk(0.245, 0.165));
  w.put("report", "report", on_desk(0.45, -0.12), turned_by(-8));
  w.drape("paper", "paper", {0.21, 0.297}, 0.297 / 32, on_desk(-0.52, -0.30, 0.005), turned_by(7));
  w.add(lead());
  w.drape("coat", "wool", {0.9, 0.72}, 0.0225, {-0.30, -1.22, 1.02});
  return w.take();
}

// Its corner hangs from the middle peg. It starts flat and upright, balanced, and falls into folds.
DemoLayout make_towel() {
  LayoutWriter w("towel");
  w.look({Vec3(0.85, -2.05, 1.45), Vec3(0.0, 0.0, 1.18), 30});
  w.fix("pegs", "pegs");
  DrapeOperation towel;
  towel.object = towel.material = "towel";
  towel.size = Vec2(0.45, 0.70);
  towel.cell = 0.029;
  towel.start.rotation = turned(Vec3::UnitY(), -33) * turned(Vec3::UnitX(), 90);
  const Vec3 corner(0, -0.06, shapes::kPegHeight - 0.01);
  towel.start.translation =
      corner - towel.start.rotation.matrix() * Vec3(towel.size->x() / 2, towel.size->y() / 2, 0);
  towel.pins = {corner};
  towel.held_by = {"pegs"};
  w.add(towel);
  return w.take();
}

}  // namespace trivet
