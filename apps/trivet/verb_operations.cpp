// Verbs that do one operation to one object of a scene: push, turn, fix, ... Their options are made
// of the operations' tables.
#include <algorithm>

#include "apps/trivet/change_scene.h"
#include "apps/trivet/operation_options.h"

namespace trivet::apps {
namespace {

struct Arguments {
  SceneArguments scene;
  std::string object;
  std::unique_ptr<OperationOptions> options;
};

Verb add_operation(CLI::App& app, const CommonOptions& common, const Operation& kind,
                   const Form& form) {
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
  return {verb, [arguments, kind, &common] {
            Operation start = kind;
            std::visit([&](auto& o) { o.object = arguments->object; }, start);
            const Operation operation = arguments->options->operation(std::move(start));
            return change_scene(
                arguments->scene, {}, common,
                [&](const SceneFile&, const RunOptions&) { return SceneChange{operation}; });
          }};
}

}  // namespace

std::vector<Verb> add_operations(CLI::App& app, const CommonOptions& common) {
  std::vector<Verb> verbs;
  for (const std::string op :
       {"push", "turn", "pick_up", "translate", "rotate", "fix", "unfix", "material", "drape"})
    for (const Operation& kind : all_kinds()) {
      const std::vector<Form>& forms = table_of(kind).forms;
      // The last form of a name is the plain one.
      const auto form =
          std::find_if(forms.rbegin(), forms.rend(), [&](const Form& f) { return op == f.op; });
      if (form != forms.rend()) verbs.push_back(add_operation(app, common, kind, *form));
    }
  return verbs;
}

}  // namespace trivet::apps
