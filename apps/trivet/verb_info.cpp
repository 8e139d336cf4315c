#include <iostream>

#include "apps/trivet/verbs.h"
#include "core/index/shape.h"
#include "core/io/sandboxed_import.h"
#include "ops/files/report/model_info.h"

namespace trivet::apps {

Verb add_info(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand("info", "Describe a model file");
  struct Arguments {
    std::string path;
    Tessellation tessellation;
  };
  const auto arguments = std::make_shared<Arguments>();
  verb->add_option("model", arguments->path, "The model file")->required()->type_name("MODEL");
  add_tessellation_options(*verb, arguments->tessellation);
  return {verb, [arguments, &common] {
            check_tessellation(arguments->tessellation, arguments->path);
            const Model model =
                import_model(arguments->path, common.limits(), arguments->tessellation);
            const auto shape = make_shape(model.mesh);
            std::cout << (common.json ? model_info_json(model, *shape)
                                      : model_info_text(model, *shape));
            return 0;
          }};
}

}  // namespace trivet::apps
