#include "ops/demo/demo.h"

#include "core/base/error.h"
#include "ops/demo/layouts.h"

namespace trivet {

const Model& DemoLayout::model(const std::string& file) const {
  for (const DemoModel& m : models)
    if (m.file == file) return m.model;
  throw Error(Error::Kind::BadInput, "the demo '" + name + "' has no model '" + file + "'");
}

std::vector<std::string> demo_names() { return {"spoon-saucer", "breakfast"}; }

DemoLayout make_demo(const std::string& name) {
  if (name == "spoon-saucer") return make_spoon_saucer();
  if (name == "breakfast") return make_breakfast();
  throw Error(Error::Kind::BadInput,
              "no demo '" + name + "'; there are spoon-saucer and breakfast");
}

std::string layout_json(const DemoLayout& demo) { return write_layout(demo.layout) + "\n"; }

}  // namespace trivet
