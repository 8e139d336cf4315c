// An office along a wall, and a workshop.
#include "apps/demo/problem_writer.h"

namespace trivet {
namespace {

using Json = ProblemWriter::Json;

void add_on_desk(ProblemWriter& w, const char* object, Json more = Json::object()) {
  w.add(object, object, std::move(more));
  w.relate("on", object, "desk", {{"level", "top"}});
}

void add_furniture(ProblemWriter& w) {
  w.fix("wall", "wall", 1, Vec2(0, 0.9));
  w.add("desk", "desk");
  w.relate("against", "desk", "wall", {{"side", "back"}, {"gap", {0.02, 0.05}}});
  w.relate("same", "desk", "wall");
  w.relate("within", "desk", "", {{"region", {{-1.6, -1}, {0.6, -1}, {0.6, 0.9}, {-1.6, 0.9}}}});
  w.add_zone("desk", "drawers", Vec3(0.29, -0.75, 0.05), Vec3(0.71, -0.36, 0.70));
  w.add("bookcase", "bookcase");
  w.relate("against", "bookcase", "wall", {{"side", "back"}, {"gap", {0.01, 0.03}}});
  w.relate("same", "bookcase", "wall");
  w.relate("right_of", "bookcase", "desk", {{"gap", {0.05, 0.6}}, {"overlap", 0.3}});
  w.add_zone("bookcase", "reach", Vec3(-0.33, -0.60, 0.05), Vec3(0.33, -0.17, 1.10));
  w.add("chair", "chair");
  w.relate("in_front_of", "chair", "desk", {{"gap", {0.05, 0.4}}, {"overlap", 0.2}});
  w.relate("facing", "chair", "desk", {{"tolerance", 25}});
  w.add("waste_basket", "waste_basket");
  w.relate("left_of", "waste_basket", "desk", {{"gap", {0.02, 0.3}}, {"overlap", 0.2}});
  w.add("plant", "plant");
  w.relate("on", "plant", "bookcase", {{"level", "top"}});
}

void add_desk_things(ProblemWriter& w) {
  add_on_desk(w, "monitor");
  w.relate("same", "monitor", "desk");
  w.relate("centred", "monitor", "desk",
           {{"along", "x"}, {"offset", {-0.2, 0}}, {"tolerance", 0.1}});
  w.relate("centred", "monitor", "desk",
           {{"along", "y"}, {"offset", {0, 0.2}}, {"tolerance", 0.05}});
  add_on_desk(w, "keyboard");
  w.relate("in_front_of", "keyboard", "monitor", {{"gap", {0.05, 0.25}}, {"overlap", 0.9}});
  w.relate("same", "keyboard", "monitor");
  w.relate("centred", "keyboard", "monitor", {{"along", "x"}, {"weight", 1}, {"tolerance", 0.03}});
  add_on_desk(w, "mouse");
  w.relate("right_of", "mouse", "keyboard", {{"gap", {0.02, 0.10}}});
  w.relate("same", "mouse", "keyboard", {{"tolerance", 10}});
  add_on_desk(w, "telephone");
  w.relate("left_of", "telephone", "monitor", {{"gap", {0.02, 0.3}}, {"overlap", 0.2}});
  w.relate("facing", "telephone", "", {{"point", {-0.5, -0.8}}, {"tolerance", 20}});
  add_on_desk(w, "lamp");
  w.relate("right_of", "lamp", "monitor", {{"gap", {0.05, 0.5}}, {"overlap", 0}});
  add_on_desk(w, "report");
  w.relate("right_of", "report", "keyboard", {{"gap", {0.1, 0.5}}, {"overlap", 0.2}});
  add_on_desk(w, "mug");
  w.relate("near", "mug", "monitor", {{"distance", 0.15}});
  w.relate("near", "mug", "telephone", {{"distance", 0.6}, {"weight", 0.2}});
}

}  // namespace

ArrangedDemo make_office3() {
  ProblemWriter w("office3");
  w.look({Vec3(-1.75, -2.60, 2.10), Vec3(0.05, 0.40, 0.55), 36});
  add_furniture(w);
  add_desk_things(w);
  Json books = Json::array();
  constexpr const char* kBooks[] = {"book_red", "book_blue", "book_green", "book_yellow"};
  for (int i = 0; i < 8; ++i) {
    const std::string name = "book_" + std::to_string(i + 1);
    w.add(name, kBooks[i % 4]);
    books.push_back(name);
  }
  w.add_relation({{"is", "row"},
                  {"of", books},
                  {"on", "bookcase"},
                  {"level", 2},
                  {"gap", 0.001},
                  {"align", "left"},
                  {"across", "front"},
                  {"inset", 0.03},
                  {"order", "any"}});
  w.add("binder", "binder");
  w.relate("on", "binder", "bookcase", {{"level", 1}});
  w.relate("same", "binder", "bookcase");
  w.add_relation({{"is", "keep"},
                  {"a", "*"},
                  {"distance", 0.005},
                  {"except", Json::array({Json::array({"book_*", "*"}), Json::array({"desk", "*"}),
                                          Json::array({"bookcase", "*"})})}});
  return w.take();
}

// Small parts let fall into a bin on the bench, tools beside it.
ArrangedDemo make_workshop() {
  ProblemWriter w("workshop");
  w.look({Vec3(0.75, -1.45, 1.85), Vec3(0.02, 0, 0.86), 36});
  w.fix("bench", "workbench");
  w.add("bin", "parts_bin", {{"yaw", {0, 90}}});
  w.relate("on", "bin", "bench", {{"level", "top"}});
  for (const auto& [model, count] : {std::pair("bracket", 8), {"bolt", 12}, {"nut", 10}})
    for (int i = 1; i <= count; ++i) {
      const std::string name = model + std::string("_") + std::to_string(i);
      w.add(name, model, {{"pose", "free"}});
      w.relate("in", name, "bin");
      w.relate("centred", name, "bin", {{"tolerance", 0.075}});  // off the rim
    }
  w.add("toolbox", "toolbox");
  w.relate("on", "toolbox", "bench", {{"level", "top"}});
  w.relate("same", "toolbox", "bench");
  w.relate("left_of", "toolbox", "bin", {{"gap", {0.05, 0.6}}, {"overlap", 0.3}});
  for (const char* tool : {"hammer", "screwdriver"}) {
    w.add(tool, tool, {{"pose", "free"}});
    w.relate("on", tool, "bench", {{"level", "top"}});
    w.relate("right_of", tool, "bin", {{"gap", {0.02, 0.5}}, {"overlap", 0}});
  }
  w.relate("near", "screwdriver", "hammer", {{"distance", 0.15}});
  Json jars = Json::array();
  for (int i = 1; i <= 5; ++i) {
    w.add("jar_" + std::to_string(i), i % 2 ? "jar" : "tin");
    jars.push_back("jar_" + std::to_string(i));
  }
  w.add_relation({{"is", "row"},
                  {"of", jars},
                  {"on", "bench"},
                  {"level", "top"},
                  {"gap", 0.03},
                  {"align", "left"},
                  {"across", "back"},
                  {"inset", 0.02}});
  w.add("basket", "waste_basket");
  w.relate("right_of", "basket", "bench", {{"gap", {0.05, 0.3}}});
  for (const char* whole : {"bin", "toolbox"})
    w.relate("within", whole, "",
             {{"region", {{-0.74, -0.31}, {0.74, -0.31}, {0.74, 0.31}, {-0.74, 0.31}}}});
  w.add_zone("bench", "work", Vec3(-0.5, -0.9, 0.05), Vec3(0.5, -0.33, 1.8));
  return w.take();
}

}  // namespace trivet
