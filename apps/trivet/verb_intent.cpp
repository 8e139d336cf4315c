// intent: what stands on and in what, as the poses mean it.
#include <cmath>
#include <cstdio>
#include <iostream>

#include "apps/trivet/foreign_scenes.h"
#include "apps/trivet/verbs.h"
#include "core/base/count_of.h"
#include "core/base/quoted.h"
#include "ops/files/foreign/repair_json.h"
#include "ops/files/report/scene_file.h"
#include "ops/mend/neighbours.h"

namespace trivet::apps {
namespace {

struct IntentArguments {
  std::string file;
  double tolerance = 0;
  ForeignArguments foreign;
};

Scene scene_of(const IntentArguments& arguments, const CommonOptions& common) {
  if (!is_of_others(arguments.file))
    return std::move(read_scene_file(arguments.file, common.limits()).scene);
  return std::move(
      open_scene(arguments.file, open_options(arguments.foreign, common)).judged.scene);
}

std::string names_of(const Scene& scene, const std::vector<ObjectId>& ids) {
  std::string out;
  for (const ObjectId id : ids)
    out += (out.empty() ? "" : ", ") + trivet::quoted(scene.at(id).name);
  return out;
}

// "on "plate" 80 %, "knife" 20 %; in "tray"; sunk by 2 mm; leans on "cup"; beside "bowl"".
std::string object_text(const Scene& scene, const Intent& intent, const ObjectIntent& o) {
  char text[80];
  std::string out;
  for (const IntendedSupport& s : o.on) {
    std::snprintf(text, sizeof text, " %.0f %%", 100 * s.share);
    out += (out.empty() ? "on " : ", ") + trivet::quoted(named(scene, s.on).name) + text;
    if (s.either_way) out += " (or the other way round)";
  }
  if (out.empty()) out = "on nothing";
  if (o.inside) out += "; in " + trivet::quoted(scene.at(*o.inside).name);
  if (!o.on.empty() && std::abs(o.gap) >= 1e-4) {
    std::snprintf(text, sizeof text, "; %s by %.3g mm", o.gap > 0 ? "floats" : "is sunk",
                  1000 * std::abs(o.gap));
    out += text;
  }
  const IntendedNeighbours around = intended_neighbours(scene, intent, o);
  if (!around.leans_on.empty())
    out += "; leans on " + names_of(scene, around.leans_on);
  else if (!o.is_level)
    out += "; leans, or lies in a heap";
  if (!around.beside.empty()) out += "; beside " + names_of(scene, around.beside);
  return out;
}

int tell(const IntentArguments& arguments, const CommonOptions& common) {
  const Scene scene = scene_of(arguments, common);
  const Intent intent = infer_intent(
      scene, arguments.tolerance > 0 ? std::optional(arguments.tolerance) : std::nullopt);
  if (common.json) {
    std::cout << intent_json(scene, intent).dump() << "\n";
    return 0;
  }
  for (const ObjectIntent& o : intent.objects)
    std::cout << trivet::quoted(scene.at(o.id).name) << ": " << object_text(scene, intent, o)
              << "\n";
  char text[80];
  std::snprintf(text, sizeof text, "; poses were taken to be off by %.3g mm\n",
                1000 * intent.tolerance);
  if (!common.quiet) std::cout << count_of(intent.objects.size(), "free object") << text;
  return 0;
}

}  // namespace

std::vector<Verb> add_intent(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand("intent",
                                            "Infer what stands on, in and beside what, and leans "
                                            "on it, in a scene of any program, even where its "
                                            "poses interpenetrate and float");
  const auto arguments = std::make_shared<IntentArguments>();
  verb->add_option("file", arguments->file,
                   "A scene: MJCF, URDF, SDF, USD, glTF, or written by trivet")
      ->required()
      ->type_name("SCENE");
  verb->add_option("--tolerance", arguments->tolerance,
                   "Largest error of the poses (metres); 0: found from the poses")
      ->check(number_from(0, 1));
  add_foreign_options(*verb, arguments->foreign);
  return {{verb, [arguments, &common] { return tell(*arguments, common); },
           "trivet intent kitchen.xml\n"
           "trivet intent kitchen.xml --tolerance 0.005 --json\n"}};
}

}  // namespace trivet::apps
