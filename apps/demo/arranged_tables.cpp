// Tables laid for six.
#include "apps/demo/problem_writer.h"

namespace trivet {
namespace {

using Json = ProblemWriter::Json;

// One person's place; the plate's front is where the person sits.
void add_setting(ProblemWriter& w, const std::string& seat, const Vec2& at, double yaw) {
  const std::string plate = "plate_" + seat, knife = "knife_" + seat, spoon = "spoon_" + seat;
  const std::string saucer = "saucer_" + seat, cup = "cup_" + seat, glass = "glass_" + seat;
  w.add(plate, "plate", {{"yaw", {yaw}}});
  w.relate("on", plate, "table");
  w.relate("at", plate, "", {{"point", {at.x(), at.y()}}, {"tolerance", 0.02}});
  // Blade and bowl point away.
  w.add(knife, "knife", {{"yaw", {yaw - 90}}});
  w.relate("on", knife, "table");
  w.relate("right_of", knife, plate, {{"gap", {0.01, 0.03}}});
  w.relate("centred", knife, plate, {{"along", "y"}, {"tolerance", 0.02}});
  w.add(spoon, "spoon", {{"yaw", {yaw - 90}}, {"pose", "free"}});
  w.relate("on", spoon, "table");
  w.relate("left_of", spoon, plate, {{"gap", {0.01, 0.04}}});
  w.add(saucer, "saucer");
  w.relate("on", saucer, "table");
  w.relate("behind", saucer, plate, {{"gap", {0, 0.12}}, {"overlap", 0}});
  w.relate("near", saucer, plate, {{"distance", 0.12}});
  w.add(cup, "cup");
  w.relate("on", cup, saucer);
  w.relate("centred", cup, saucer, {{"tolerance", 0.01}});
  w.add(glass, "glass");
  w.relate("on", glass, "table");
  w.relate("behind", glass, plate, {{"gap", {0, 0.12}}, {"overlap", 0}});
  w.relate("near", glass, knife, {{"distance", 0.15}});
  w.add("toast_" + seat, "toast");
  w.relate("on", "toast_" + seat, plate);
  w.relate("centred", "toast_" + seat, plate, {{"tolerance", 0.03}});
}

// In the middle of the table, fruit in the bowl.
void add_dishes(ProblemWriter& w) {
  for (const char* name : {"bowl", "teapot", "jug", "loaf"}) {
    w.add(name, name);
    w.relate("on", name, "table");
    w.relate("centred", name, "table", {{"along", "y"}, {"tolerance", 0.1}, {"weight", 0.5}});
  }
  for (const char* name : {"apple_1", "apple_2", "apple_3"}) {
    w.add(name, "apple", {{"pose", "free"}});
    w.relate("in", name, "bowl");
  }
}

void keep_apart(ProblemWriter& w, double distance) {
  Json except = Json::array();
  for (const auto& [a, b] :
       {std::pair("cup_*", "saucer_*"), std::pair("toast_*", "plate_*"), std::pair("apple_*", "*")})
    except.push_back(Json::array({a, b}));
  w.add_relation({{"is", "keep"}, {"a", "*"}, {"distance", distance}, {"except", except}});
}

// @param spacing  of the seats along the table. @param out  of the plates from its middle line.
void add_seats(ProblemWriter& w, double spacing, double out) {
  int seat = 0;
  for (const double side : {-1.0, 1.0})
    for (const double x : {-spacing, 0.0, spacing})
      add_setting(w, std::to_string(++seat), Vec2(x, side * out), side < 0 ? 0 : 180);
}

}  // namespace

ArrangedDemo make_table_for_six() {
  ProblemWriter w("table-for-six");
  w.look({Vec3(0.75, -1.75, 2.25), Vec3(0.02, -0.05, 0.92), 32});
  w.fix("table", "table", 1.25);
  add_seats(w, 0.5, 0.37);
  add_dishes(w);
  keep_apart(w, 0.004);
  return w.take();
}

// The same on 1.28 x 0.85 m: what is between the plates is nearly full.
ArrangedDemo make_tight_table() {
  ProblemWriter w("tight-table");
  w.look({Vec3(0.65, -1.55, 2.00), Vec3(0.02, -0.05, 0.80), 32});
  w.fix("table", "table", 1.28 / 1.2);
  add_seats(w, 0.43, 0.295);
  add_dishes(w);
  keep_apart(w, 0.002);
  return w.take();
}

}  // namespace trivet
