#include <iostream>

#include "apps/trivet/verbs.h"
#include "core/index/shape.h"
#include "core/io/process/sandboxed_import.h"
#include "ops/files/arrange/model_supports.h"

namespace trivet::apps {

std::vector<Verb> add_info(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand("info", "Describe a model file");
  struct Arguments {
    std::string path;
    Tessellation tessellation;
    ModelSupports supports;
  };
  const auto arguments = std::make_shared<Arguments>();
  verb->add_option("model", arguments->path, "The model file")->required()->type_name("MODEL");
  verb->add_flag("--poses", arguments->supports.poses,
                 "Stable poses on a plane, with their probabilities and margins");
  verb->add_flag("--surfaces", arguments->supports.surfaces,
                 "Surfaces to set things down on, with the head room above");
  add_tessellation_options(*verb, arguments->tessellation);
  return {{verb,
           [arguments, &common] {
             check_tessellation(arguments->tessellation, arguments->path);
             const Model model =
                 import_model(arguments->path, common.limits(), arguments->tessellation);
             const auto shape = make_shape(model.mesh);
             const ModelSupports& asked = arguments->supports;
             std::cout << (common.json ? model_info_json(model, *shape, asked)
                                       : model_info_text(model, *shape, asked));
             return 0;
           },
           "trivet info mug.obj\n"
           "trivet info mug.obj --poses --surfaces --json\n"}};
}

}  // namespace trivet::apps
