// Examples of every verb, the end of its --help. tests/apps/test_help.py runs each of them.
#include <map>

#include "apps/trivet/help.h"

namespace trivet::apps {
namespace {

const std::map<std::string, std::string> kExamples = {
    {"info",
     "trivet info mug.obj\n"
     "trivet info mug.obj --poses --surfaces --json\n"},
    {"run",
     "trivet run layout.json -o scene.glb --report report.json\n"
     "trivet run layout.json -o out/scene.xml --picture out/scene.png\n"},
    {"put",
     "trivet put scene.glb mug.obj --position 0.3 0 1 -o more.glb\n"
     "trivet put scene.glb mug.obj --on slab --at 0.2 0.1 --keep 0.01 -o more.glb\n"
     "trivet put scene.glb mug.obj --name cup --position -0.3 0 1 --rotation 0.7 0.7 0 0 "
     "--material ceramic -o more.glb\n"},
    {"push",
     "trivet push scene.glb mug --direction 1 0 --distance 0.1 -o pushed.glb\n"
     "trivet push scene.glb mug --to 0.2 -0.1 --no-slide -o pushed.glb\n"},
    {"turn",
     "trivet turn scene.glb mug --angle-deg 90 -o turned.glb\n"
     "trivet turn scene.glb mug --about line --angle-deg 20 --settle -o tilted.glb\n"},
    {"pick-up",
     "trivet pick-up scene.glb mug --distance 0.2 -o lifted.glb\n"
     "trivet pick-up scene.glb mug --with slab --distance 0.05 -o lifted.glb\n"},
    {"translate",
     "trivet translate scene.glb mug --by 0 0.2 0.3 --settle -o moved.glb\n"
     "trivet translate scene.glb mug --by 0.1 0 0.3 --settle -o moved.glb\n"},
    {"rotate",
     "trivet rotate scene.glb mug --axis 0 0 1 --angle-deg 45 -o turned.glb\n"
     "trivet rotate scene.glb mug --axis 0 0 1 --angle-deg -90 --centre 0.1 0 0 -o turned.glb\n"},
    {"fix",
     "trivet fix scene.glb mug -o fixed.glb\n"
     "trivet fix scene.glb mug -o fixed.glb --report fixed.json\n"},
    {"unfix",
     "trivet unfix scene.glb slab -o free.glb\n"
     "trivet unfix scene.glb slab -o free.glb --report free.json\n"},
    {"material",
     "trivet material scene.glb mug --material wood -o wooden.glb\n"
     "trivet material scene.glb mug --friction 0.3 --density 2700 -o heavy.glb\n"},
    {"check",
     "trivet check scene.glb\n"
     "trivet check scene.glb --friction 0.3 --object mug --json\n"},
    {"export",
     "trivet export scene.glb -o scene.xml\n"
     "trivet export scene.glb -o objects.csv\n"},
    {"render",
     "trivet render scene.glb -o scene.png --width 320 --height 240 --renderer path\n"
     "trivet render scene.glb --dome 4 --coco dataset --width 160 --height 120\n"
     "trivet render layout.json --animation film.webp --fps 4 --width 160 --height 120\n"},
    {"zlist",
     "trivet zlist scene.glb -o lists.png\n"
     "trivet zlist scene.glb --pixel 128 128 --json\n"},
    {"arrange",
     "trivet arrange problem.json -o scene.glb --report report.json\n"
     "trivet arrange problem.json --seed 7 -o scene.glb\n"},
    {"demo",
     "trivet demo spoon-saucer -o scene.glb\n"
     "trivet demo breakfast -o breakfast.glb --export breakfast\n"},
    {"session",
     "echo '{\"query\": \"objects\"}' | trivet session scene.glb\n"
     "trivet session layout.json --journal session < operations.jsonl\n"},
    {"serve",
     "trivet serve scene.glb --port 8080\n"
     "trivet serve --recipe recipe.json --seed 7 --socket trivet.socket\n"},
    {"replay",
     "trivet replay session -o scene.glb\n"
     "trivet replay session -o scene.glb --report report.json\n"},
    {"backends",
     "trivet backends\n"
     "trivet backends --recalibrate --json\n"},
    {"batch",
     "trivet batch recipe.json --count 100 --seed 7 --out scenes\n"
     "trivet batch recipe.json --count 100 --seed 7 --out scenes --shard 2/8\n"
     "trivet batch recipe.json --count 100 --seed 7 --only 17\n"
     "trivet batch status scenes\n"},
    {"doctor",
     "trivet doctor\n"
     "trivet doctor --out . --disk-mb 100 --json\n"},
    {"report",
     "trivet report -o case.tar -- run layout.json -o scene.glb\n"
     "trivet report -o case.tar --without-files -- check scene.glb\n"},
    {"schema",
     "trivet schema\n"
     "trivet schema recipe\n"},
};

}  // namespace

std::string examples_of(const std::string& verb) {
  const auto found = kExamples.find(verb);
  if (found == kExamples.end()) return "";
  std::string out = "Examples:\n", line;
  for (const char c : found->second) {
    line += c;
    if (c != '\n') continue;
    out += "  " + line;
    line.clear();
  }
  return out;
}

}  // namespace trivet::apps
