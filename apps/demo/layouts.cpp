// Where everything starts. Positions are metres on the table: x along it, y away from the person in
// front; the table's middle is the origin.
#include "apps/demo/layouts.h"

#include "apps/demo/layout_writer.h"
#include "apps/demo/shapes/models.h"

namespace trivet {
namespace {

constexpr double kStartHeight = 0.3;  // above what the object is to stand on

// `tilt_deg` is about the object's own x axis, before it is turned about z.
class TableWriter : public LayoutWriter {
 public:
  /// @param ground  height of the table or floor that things are put on.
  TableWriter(std::string name, double ground) : LayoutWriter(std::move(name)), m_ground(ground) {}

  void put(const std::string& object, const std::string& model, double x, double y,
           double turn_deg = 0, double tilt_deg = 0) {
    LayoutWriter::put(object, model, Vec3(x, y, m_ground + kStartHeight),
                      turned(Vec3::UnitZ(), turn_deg) * turned(Vec3::UnitX(), tilt_deg));
  }

 private:
  double m_ground;
};

// A person's place: angles and positions as the person in front sees them; the other one is across.
void put_drinks(TableWriter* w, const std::string& who, double side) {
  const double turn = side > 0 ? 0 : 180;
  const double x = side * 0.125, y = side * -0.210;
  w->put("saucer_" + who, "saucer", x, y, turn);
  w->put("cup_" + who, "cup", x, y, turn + 35);
  w->put("spoon_" + who, "spoon", x + side * 0.005, y - side * 0.051, turn + 173);
}

void lay_breakfast(TableWriter& w) {
  w.put("plate_front", "plate", -0.13, -0.20);
  w.put("plate_back", "plate", 0.15, 0.205);
  put_drinks(&w, "front", 1);
  put_drinks(&w, "back", -1);
  w.put("toast", "toast", -0.135, -0.200, 12);
  w.put("knife", "knife", -0.035, -0.170, 262);
  w.put("egg_cup", "egg_cup", 0.145, 0.200);
  w.put("egg", "egg", 0.145, 0.200);
  w.put("glass_front", "glass", 0.025, -0.090);
  w.put("glass_back", "glass", -0.010, 0.125);
  w.put("teapot", "teapot", -0.165, 0.040, 165);
  w.put("jug", "jug", 0.130, 0.015, 300);
  w.put("bowl", "bowl", 0.360, -0.030);
  w.put("apple_1", "apple", 0.405, -0.030, 15);
  w.put("apple_2", "apple", 0.338, 0.010, 140);
  w.put("apple_3", "apple", 0.338, -0.070, 265);
  w.put("banana_1", "banana", 0.375, 0.015, 320, -10);
  w.put("banana_2", "banana", 0.380, -0.060, 325, -10);
  w.put("loaf", "loaf", -0.370, 0.040, 310);
}

}  // namespace

DemoLayout make_spoon_saucer() {
  TableWriter w("spoon-saucer", 0);
  w.put("saucer", "saucer", 0, 0);
  w.look({Vec3(0.10, -0.27, 0.25), Vec3(0.012, 0, 0.008), 29});
  w.put("spoon", "spoon", 0.036, 0.014, 29);
  return w.take();
}

DemoLayout make_breakfast() {
  TableWriter w("breakfast", shapes::kClothHeight);
  w.look({Vec3(0.40, -1.08, 1.34), Vec3(0.005, -0.010, 0.76), 33});
  w.fix("table", "table");
  lay_breakfast(w);
  return w.take();
}

// The cloth comes down before the table is laid.
DemoLayout make_tablecloth() {
  TableWriter w("tablecloth", shapes::kClothHeight);
  w.look({Vec3(1.05, -1.95, 1.75), Vec3(0.0, -0.02, 0.62), 32});
  w.fix("table", "bare_table");
  w.drape("cloth", "cotton", {1.6, 1.2}, 0.034, {0, 0, shapes::kTableHeight + 0.01});
  lay_breakfast(w);
  return w.take();
}

}  // namespace trivet
