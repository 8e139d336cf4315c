#include <iostream>

#include "apps/trivet/verbs.h"
#include "core/index/shape.h"
#include "core/io/isolated.h"
#include "ops/report/model_info.h"

namespace trivet::apps {

Verb add_info(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand("info", "Says what is in a model file");
  const auto path = std::make_shared<std::string>();
  verb->add_option("model", *path, "The model file")->required()->type_name("MODEL");
  return {verb, [path, &common] {
            const Model model = import_model(*path, common.limits());
            const auto shape = make_shape(model.mesh);
            std::cout << (common.json ? model_info_json(model, *shape)
                                      : model_info_text(model, *shape));
            return 0;
          }};
}

}  // namespace trivet::apps
