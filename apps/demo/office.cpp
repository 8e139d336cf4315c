// OFFICE1 and OFFICE2. The desk's middle is above the origin; who works at it sits at -y.
#include "apps/demo/layout_writer.h"
#include "apps/demo/layouts.h"
#include "apps/demo/shapes/models.h"

namespace trivet {
namespace {

using shapes::kBookcaseBoards;
using shapes::kBookcaseHeight;
using shapes::kDeskHeight;

const Vec2 kBookcase(1.24, 0.16), kMug(0.245, 0.165);

Rotation about_x(double angle_deg) { return turned(Vec3::UnitX(), angle_deg); }
Rotation about_y(double angle_deg) { return turned(Vec3::UnitY(), angle_deg); }

Vec3 above(double height, double x, double y, double by = 0.05) { return {x, y, height + by}; }
Vec3 above_desk(double x, double y, double by = 0.05) { return above(kDeskHeight, x, y, by); }
Vec3 in_bookcase(int board, double x, double y = -0.15) {
  return above(kBookcaseBoards[board], kBookcase.x() + x, kBookcase.y() + y, 0.02);
}

void put_furniture(LayoutWriter* w) {
  w->put("desk", "desk", above(0, 0, 0));
  w->put("bookcase", "bookcase", above(0, kBookcase.x(), kBookcase.y()));
  w->put("chair", "chair", above(0, -0.16, -1.05), about_z(180));
  w->turn("chair", 22);
  w->push("chair", Vec2(0, 1), 0.43);
  w->put("waste_basket", "waste_basket", above(0, -1.20, -0.40));
  w->push_to("waste_basket", Vec2(-0.95, -0.16));
}

// One beside the other, pushed together; the last one leans.
void put_books(LayoutWriter* w) {
  w->put("book_green", "book_green", in_bookcase(2, 0.300));
  w->put("book_red", "book_red", in_bookcase(2, 0.240));
  w->put("book_blue", "book_blue", in_bookcase(2, 0.170));
  for (const char* book : {"book_green", "book_red", "book_blue"}) w->push(book, Vec2(1, 0), 0.1);
  w->put("book_yellow", "book_yellow", in_bookcase(2, 0.140), about_y(16));
}

// A pencil that stands in the mug at a slant, its tip up, `aside` of the middle.
void put_pencil(LayoutWriter* w, const std::string& name, const Vec2& mug, double turn_deg,
                double aside) {
  const Rotation turn = about_z(turn_deg);
  const Vec3 middle = above_desk(mug.x(), mug.y(), 0.115) + turn.matrix() * Vec3(0.016, aside, 0);
  w->put(name, "pencil", middle, turn * about_y(-82));
}

void put_desk_things(LayoutWriter* w) {
  w->put("monitor", "monitor", above_desk(-0.14, 0.17));
  w->turn("monitor", -4);
  w->put("keyboard", "keyboard", above_desk(-0.15, -0.20));
  w->push("keyboard", Vec2(0, 1), 0.07);
  w->put("mouse", "mouse", above_desk(0.15, -0.14));
  w->turn("mouse", -6);
  w->put("telephone", "telephone", above_desk(-0.55, 0.10));
  w->turn("telephone", 16);
  w->push("telephone", Vec2(-1, 2), 0.10);
  w->put("lamp", "lamp", above_desk(0.60, 0.22), about_z(180));
  w->turn("lamp", 30);
  w->put("report", "report", above_desk(0.45, -0.15));
  w->turn("report", -8);
  // The mug goes to the monitor and takes the pencil with it.
  w->put("mug", "mug", above_desk(0.36, 0.02), about_z(-70));
  put_pencil(w, "pencil", Vec2(0.36, 0.02), 200, 0);
  w->push_to("mug", kMug);
}

LayoutWriter write_office1(const std::string& name) {
  LayoutWriter w(name);
  w.look({Vec3(-1.62, -3.24, 2.15), Vec3(0.23, 0, 0.50), 33.5});
  put_furniture(&w);
  put_desk_things(&w);
  put_books(&w);
  return w;
}

// Stops at the first obstacle instead of sliding along it or climbing onto it.
void push_until_blocked(LayoutWriter* w, const std::string& object, const Vec2& direction,
                        double distance) {
  PushOperation push;
  push.object = object;
  push.direction = direction;
  push.distance = distance;
  push.slide = false;
  push.step_up = 0.002;
  w->add(push);
}

void translate(LayoutWriter* w, const std::string& object, const Vec3& by, bool settle = false) {
  TranslateOperation o;
  o.object = object;
  o.by = by;
  o.settle = settle;
  w->add(o);
}

// The leaning book: tilted back off the others, picked up, out of the bookcase, and let go over the
// desk, where it lies on its side.
void take_book_to_desk(LayoutWriter* w, const std::string& book) {
  TurnOperation tilt;
  tilt.object = book;
  tilt.about = TurnOperation::About::Line;
  tilt.with = "bookcase";
  tilt.axis = Vec3::UnitY();
  tilt.angle_deg = -12;
  w->add(tilt);
  PickUpOperation pick_up;
  pick_up.object = book;
  pick_up.with = "bookcase";
  pick_up.distance = 0.03;
  w->add(pick_up);
  translate(w, book, Vec3(0, -0.42, 0));
  translate(w, book, Vec3(-1.35, 0, 0.15));
  RotateOperation rotate;
  rotate.object = book;
  rotate.axis = Vec3(0, 1, 0.2);
  rotate.angle_deg = -90;
  w->add(rotate);
  translate(w, book, Vec3(0, 0.13, 0));
  translate(w, book, Vec3(0, 0, -0.5), true);
}

}  // namespace

DemoLayout make_office1() { return write_office1("office1").take(); }

DemoLayout make_office2() {
  LayoutWriter w = write_office1("office2");
  w.push("chair", Vec2(-0.5, -1), 0.17);
  w.turn("chair", 75);
  w.turn("keyboard", 8);
  push_until_blocked(&w, "keyboard", Vec2(0, 1), 0.20);
  w.push("mouse", Vec2(0.4, 1), 0.09);
  w.turn("mouse", 35);
  w.turn("lamp", -25);
  put_pencil(&w, "pencil_2", kMug, 20, 0.012);
  w.put("letter_1", "letter", above_desk(0.50, -0.12, 0.05), about_z(17));
  w.put("pen", "pen", above_desk(0.47, -0.13, 0.08), about_z(70));
  w.put("letter_2", "letter", above_desk(-0.57, -0.15, 0.05), about_z(-31));
  w.put("cup", "cup", above_desk(-0.62, -0.08, 0.08), about_z(200));
  w.push("letter_2", Vec2(0.1, -1), 0.07);
  w.put("plant", "plant", above(kBookcaseHeight, kBookcase.x() + 0.12, kBookcase.y()));
  w.put("binder", "binder", in_bookcase(1, 0.195), about_y(15));
  w.put("paper_ball_1", "paper_ball", above(0.26, -0.93, -0.10), about_x(30));
  w.put("paper_ball_2", "paper_ball", above(0, -0.78, -0.45), about_x(100));
  take_book_to_desk(&w, "book_yellow");
  w.push("book_blue", Vec2(0, -1), 0.03);
  return w.take();
}

}  // namespace trivet
