// OFFICE1 and OFFICE2. The desk's middle is above the origin; who works at it sits at -y.
#include "core/shapes/models.h"
#include "ops/demo/layout_writer.h"
#include "ops/demo/layouts.h"

namespace trivet {
namespace {

using shapes::kBookcaseBoards;
using shapes::kBookcaseHeight;
using shapes::kDeskHeight;

const Vec2 kBookcase(1.24, 0.16), kMug(0.245, 0.165);

Rotation about_x(double angle_deg) { return turned(Vec3::UnitX(), angle_deg); }
Rotation about_y(double angle_deg) { return turned(Vec3::UnitY(), angle_deg); }
Rotation about_z(double angle_deg) { return turned(Vec3::UnitZ(), angle_deg); }

Vec3 above(double height, double x, double y, double by = 0.05) { return {x, y, height + by}; }
Vec3 above_desk(double x, double y, double by = 0.05) { return above(kDeskHeight, x, y, by); }
Vec3 in_bookcase(int board, double x, double y = -0.15) {
  return above(kBookcaseBoards[board], kBookcase.x() + x, kBookcase.y() + y, 0.02);
}

void put_furniture(LayoutWriter* w) {
  w->put("desk", "desk", above(0, 0, 0));
  w->put("bookcase", "bookcase", above(0, kBookcase.x(), kBookcase.y()));
  w->put("chair", "chair", above(0, -0.16, -0.62), about_z(180 + 22));
  w->put("waste_basket", "waste_basket", above(0, -0.95, -0.16));
}

void put_books(LayoutWriter* w) {
  w->put("book_green", "book_green", in_bookcase(2, 0.312));
  w->put("book_red", "book_red", in_bookcase(2, 0.264), about_z(-3));
  w->put("book_blue", "book_blue", in_bookcase(2, 0.222));
  w->put("book_yellow", "book_yellow", in_bookcase(2, 0.120), about_y(16));
}

// A pencil that stands in the mug at a slant, its tip up, `aside` of the middle.
void put_pencil(LayoutWriter* w, const std::string& name, double turn_deg, double aside) {
  const Rotation turn = about_z(turn_deg);
  const Vec3 middle = above_desk(kMug.x(), kMug.y(), 0.115) + turn.matrix() * Vec3(0.016, aside, 0);
  w->put(name, "pencil", middle, turn * about_y(-82));
}

void put_desk_things(LayoutWriter* w) {
  w->put("monitor", "monitor", above_desk(-0.14, 0.17), about_z(-4));
  w->put("keyboard", "keyboard", above_desk(-0.15, -0.13));
  w->put("mouse", "mouse", above_desk(0.15, -0.14), about_z(-6));
  w->put("telephone", "telephone", above_desk(-0.60, 0.19), about_z(16));
  w->put("lamp", "lamp", above_desk(0.60, 0.22), about_z(180 + 30));
  w->put("report", "report", above_desk(0.45, -0.15), about_z(-8));
  w->put("mug", "mug", above_desk(kMug.x(), kMug.y()), about_z(-70));
  put_pencil(w, "pencil", 200, 0);
}

LayoutWriter write_office1(const std::string& name) {
  LayoutWriter w(name);
  w.look({Vec3(-1.62, -3.24, 2.15), Vec3(0.23, 0, 0.505), 33.5});
  put_furniture(&w);
  put_desk_things(&w);
  put_books(&w);
  return w;
}

}  // namespace

DemoLayout make_office1() { return write_office1("office1").take(); }

DemoLayout make_office2() {
  LayoutWriter w = write_office1("office2");
  put_pencil(&w, "pencil_2", 20, 0.012);
  w.put("letter_1", "letter", above_desk(0.50, -0.12, 0.05), about_z(17));
  w.put("letter_2", "letter", above_desk(-0.57, -0.15, 0.05), about_z(-31));
  w.put("pen", "pen", above_desk(0.47, -0.13, 0.08), about_z(70));
  w.put("cup", "cup", above_desk(-0.62, -0.08, 0.08), about_z(200));
  w.put("plant", "plant", above(kBookcaseHeight, kBookcase.x() + 0.12, kBookcase.y()));
  w.put("binder", "binder", in_bookcase(1, 0.195), about_y(15));
  w.put("paper_ball_1", "paper_ball", above(0.26, -0.93, -0.10), about_x(30));
  w.put("paper_ball_2", "paper_ball", above(0, -0.78, -0.45), about_x(100));
  return w.take();
}

}  // namespace trivet
