#include "apps/demo/arranged.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/demo/shapes/assemble.h"
#include "apps/demo/shapes/models.h"
#include "core/base/error.h"
#include "ops/files/json/json_text.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

class ProblemWriter {
 public:
  explicit ProblemWriter(std::string name) { m_out.name = std::move(name); }

  void fix(const std::string& object, const std::string& model, double scale = 1) {
    Json entry = add_object(object, model, scale);
    entry["fixed"] = true;
    entry["position"] = {0, 0, shapes::kGrid};
    m_objects.push_back(std::move(entry));
  }
  /// @param more  "pose" and "yaw".
  void add(const std::string& object, const std::string& model, Json more = Json::object(),
           double scale = 1) {
    m_objects.push_back(add_object(object, model, scale));
    Json thing = {{"object", object}};
    thing.update(more);
    m_things.push_back(std::move(thing));
  }
  void relate(const char* is, const std::string& a, const std::string& b,
              Json more = Json::object()) {
    Json relation = {{"is", is}, {"a", a}};
    if (!b.empty()) relation["b"] = b;
    relation.update(more);
    m_relations.push_back(std::move(relation));
  }
  void add_relation(Json relation) { m_relations.push_back(std::move(relation)); }
  void look(const DemoView& view) { m_out.view = view; }

  ArrangedDemo take() {
    const Json arrange = {{"seed", 1}, {"things", m_things}, {"relations", m_relations}};
    m_out.problem =
        readable_json({{"trivet", 1}, {"objects", m_objects}, {"arrange", arrange}}) + "\n";
    return std::move(m_out);
  }

 private:
  Json add_object(const std::string& object, const std::string& model, double scale) {
    const std::string file = model + ".glb";
    const auto known = [&](const DemoModel& m) { return m.file == file; };
    if (std::none_of(m_out.models.begin(), m_out.models.end(), known))
      m_out.models.push_back({file, shapes::make_model(model)});
    Json out = {{"name", object}, {"model", file}};
    if (scale != 1) out["scale"] = scale;
    return out;
  }

  ArrangedDemo m_out;
  Json m_objects = Json::array(), m_things = Json::array(), m_relations = Json::array();
};

constexpr double kTableScale = 1.25;

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

ArrangedDemo make_table_for_six() {
  ProblemWriter w("table-for-six");
  w.look({Vec3(0.75, -1.75, 2.25), Vec3(0.02, -0.05, 0.92), 32});
  w.fix("table", "table", kTableScale);
  int seat = 0;
  for (const double side : {-1.0, 1.0})
    for (const double x : {-0.5, 0.0, 0.5})
      add_setting(w, std::to_string(++seat), Vec2(x, side * 0.37), side < 0 ? 0 : 180);
  for (const char* name : {"bowl", "teapot", "jug", "loaf"}) {
    w.add(name, name);
    w.relate("on", name, "table");
    w.relate("centred", name, "table", {{"along", "y"}, {"tolerance", 0.1}, {"weight", 0.5}});
  }
  for (const char* name : {"apple_1", "apple_2", "apple_3"}) {
    w.add(name, "apple", {{"pose", "free"}});
    w.relate("in", name, "bowl");
  }
  Json except = Json::array();
  for (const auto& [a, b] :
       {std::pair("cup_*", "saucer_*"), std::pair("toast_*", "plate_*"), std::pair("apple_*", "*")})
    except.push_back(Json::array({a, b}));
  w.add_relation({{"is", "keep"}, {"a", "*"}, {"distance", 0.004}, {"except", except}});
  return w.take();
}

ArrangedDemo make_bookcase_demo() {
  ProblemWriter w("bookcase");
  w.look({Vec3(0.80, -2.75, 1.55), Vec3(0.05, 0, 0.72), 36});
  w.fix("bookcase", "bookcase");
  constexpr const char* kBooks[] = {"book_red", "book_blue", "book_green", "book_yellow"};
  constexpr int kCounts[] = {15, 17, 13};
  int number = 0;
  for (int board = 0; board < 3; ++board) {
    Json books = Json::array();
    for (int i = 0; i < kCounts[board]; ++i, ++number) {
      const std::string name = "book_" + std::to_string(board + 1) + "_" + std::to_string(i + 1);
      // Sizes repeat after 35 books only.
      w.add(name, kBooks[(number * 3 + number / 7) % 4], Json::object(), 0.9 + 0.05 * (number % 5));
      books.push_back(name);
    }
    constexpr const char* kAligned[] = {"left", "spread", "right"};
    w.add_relation({{"is", "row"},
                    {"of", books},
                    {"on", "bookcase"},
                    {"level", board},
                    {"gap", 0.0008},
                    {"align", kAligned[board]},
                    {"across", "front"},
                    {"inset", 0.03},
                    {"order", "any"}});
  }
  w.add("mug", "mug");
  w.relate("on", "mug", "bookcase", {{"level", 2}});
  for (const char* name : {"plant", "telephone"}) {
    w.add(name, name);
    w.relate("on", name, "bookcase", {{"level", "top"}});
  }
  w.relate("same", "telephone", "bookcase");
  w.relate("right_of", "plant", "telephone", {{"gap", {0.03, 1}}, {"overlap", 0}});
  w.add("waste_basket", "waste_basket");
  w.relate("right_of", "waste_basket", "bookcase", {{"gap", {0.03, 0.15}}});
  return w.take();
}

constexpr std::pair<const char*, ArrangedDemo (*)()> kArranged[] = {
    {"table-for-six", make_table_for_six}, {"bookcase", make_bookcase_demo}};

}  // namespace

std::vector<std::string> arranged_demo_names() {
  std::vector<std::string> out;
  for (const auto& [name, make] : kArranged) out.emplace_back(name);
  return out;
}

ArrangedDemo make_arranged_demo(const std::string& name) {
  std::string accepted;
  for (const auto& [known, make] : kArranged) {
    if (name == known) return make();
    accepted += (accepted.empty() ? "" : ", ") + std::string(known);
  }
  throw Error(Error::Kind::BadInput, "no arranged demo '" + name + "'; there are " + accepted);
}

}  // namespace trivet
