// Verbs that do one operation to one object of a scene: push, turn, fix, ... Their options are made
// of the operations' tables.
#include <algorithm>
#include <string_view>

#include "apps/trivet/change_scene.h"
#include "apps/trivet/operation_options.h"

namespace trivet::apps {
namespace {

struct OperationVerb {
  const char* op;
  const char* examples;
};

const OperationVerb kOperationVerbs[] = {
    {"push",
     "trivet push scene.glb mug --direction 1 0 --distance 0.1 -o pushed.glb\n"
     "trivet push scene.glb mug --to 0.2 -0.1 --no-slide -o pushed.glb\n"},
    {"turn",
     "trivet turn scene.glb mug --angle-deg 90 -o turned.glb\n"
     "trivet turn scene.glb mug --about line --angle-deg 20 --settle -o tilted.glb\n"},
    {"pick_up",
     "trivet pick-up scene.glb mug --distance 0.2 -o lifted.glb\n"
     "trivet pick-up scene.glb mug --with slab --distance 0.05 -o lifted.glb\n"},
    {"translate",
     "trivet translate scene.glb mug --by 0 0.2 0.3 --settle -o moved.glb\n"
     "trivet translate scene.glb mug --by 0.1 0 0.3 --settle -o moved.glb\n"},
    {"rotate",
     "trivet rotate scene.glb mug --axis 0 0 1 --angle-deg 45 -o turned.glb\n"
     "trivet rotate scene.glb mug --axis 0 0 1 --angle-deg -90 --centre 0.1 0 0 -o turned.glb\n"},
    {"move_joint",
     "trivet move-joint kitchen.glb drawer --until upper -o open.glb\n"
     "trivet move-joint kitchen.glb door --to 45 -o ajar.glb\n"},
    {"fix",
     "trivet fix scene.glb mug -o fixed.glb\n"
     "trivet fix scene.glb mug -o fixed.glb --report fixed.json\n"},
    {"unfix",
     "trivet unfix scene.glb slab -o free.glb\n"
     "trivet unfix scene.glb slab -o free.glb --report free.json\n"},
    {"material",
     "trivet material scene.glb mug --material wood -o wooden.glb\n"
     "trivet material scene.glb mug --friction 0.3 --density 2700 -o heavy.glb\n"},
    {"drape",
     "trivet drape scene.glb cloth --size 0.5 0.4 --cell 0.05 --position 0 0 0.6 -o draped.glb\n"
     "trivet drape scene.glb lead --path -0.3 0 0.5 0.4 0.1 0.5 -o cabled.glb\n"},
};

struct Arguments {
  SceneArguments scene;
  std::string object;
  std::unique_ptr<OperationOptions> options;
};

Verb add_operation(CLI::App& app, const CommonOptions& common, const Operation& kind,
                   const Form& form, const char* examples) {
  std::string name = form.op;
  std::replace(name.begin(), name.end(), '_', '-');
  CLI::App* const verb = app.add_subcommand(name, form.help);
  const auto arguments = std::make_shared<Arguments>();
  add_scene_argument(*verb, arguments->scene);
  verb->add_option("object", arguments->object, "Name of the object")
      ->required()
      ->type_name("OBJECT");
  arguments->options =
      std::make_unique<OperationOptions>(*verb, kind, form.op, std::set<std::string>{"object"});
  add_scene_options(*verb, arguments->scene);
  return {verb,
          [arguments, kind, &common] {
            Operation start = kind;
            std::visit([&](auto& o) { o.object = arguments->object; }, start);
            const Operation operation = arguments->options->operation(std::move(start));
            return change_scene(arguments->scene, common, [&](const SceneFile&, const RunOptions&) {
              return SceneChange{operation};
            });
          },
          examples, true, [arguments] { return VerbFiles{{arguments->scene.outputs}}; }};
}

}  // namespace

std::vector<Verb> add_operations(CLI::App& app, const CommonOptions& common) {
  std::vector<Verb> verbs;
  for (const auto& [op, examples] : kOperationVerbs)
    for (const Operation& kind : all_kinds()) {
      const std::vector<Form>& forms = table_of(kind).forms;
      // The last form of a name is the plain one.
      const auto form = std::find_if(forms.rbegin(), forms.rend(),
                                     [&](const Form& f) { return f.op == std::string_view(op); });
      if (form != forms.rend()) verbs.push_back(add_operation(app, common, kind, *form, examples));
    }
  return verbs;
}

}  // namespace trivet::apps
