#include "apps/trivet/arranging.h"
#include "apps/trivet/verbs.h"
#include "ops/files/arrange/problem.h"

namespace trivet::apps {
namespace {

struct ArrangeArguments {
  std::string problem;
  OutputPaths outputs;
  SettleArguments settle;
  ArrangingOptions arranging;
};

int arrange_problem(const ArrangeArguments& arguments, const CommonOptions& common) {
  const std::string folder = folder_of(arguments.problem);
  return arrange_file({arguments.problem,
                       arguments.outputs,
                       {},
                       {folder_from(arguments.outputs.scene, folder), ""}},
                      arguments.arranging, arguments.settle, common);
}

}  // namespace

std::vector<Verb> add_arrange(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb =
      app.add_subcommand("arrange", "Find places for objects by relations between them");
  const auto arguments = std::make_shared<ArrangeArguments>();
  verb->add_option("problem", arguments->problem,
                   "A layout with a section \"arrange\", JSON; see trivet schema arrange")
      ->required()
      ->type_name("PROBLEM.json");
  add_arranging_options(*verb, arguments->arranging);
  add_output_options(*verb, arguments->outputs);
  verb->get_option("--output")->required();
  add_settle_options(*verb, arguments->settle);
  return {{verb, [arguments, &common] { return arrange_problem(*arguments, common); },
           "trivet arrange problem.json -o scene.glb --report report.json\n"
           "trivet arrange problem.json --seed 7 -o scene.glb\n",
           true,
           [arguments] {
             return VerbFiles{outputs_of_solutions(arguments->outputs, arguments->arranging),
                              {},
                              {arguments->problem}};
           }}};
}

}  // namespace trivet::apps
