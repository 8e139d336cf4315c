#include "apps/demo/demo.h"

#include <utility>

#include "apps/demo/layouts.h"
#include "core/base/error.h"

namespace trivet {
namespace {

using Maker = DemoLayout (*)();

constexpr std::pair<const char*, Maker> kMakers[] = {
    {"spoon-saucer", make_spoon_saucer},
    {"breakfast", make_breakfast},
    {"office1", make_office1},
    {"office2", make_office2},
    {"tablecloth", make_tablecloth},
    {"desk", make_desk_demo},
    {"towel", make_towel},
    {"kitchen", make_kitchen},
};

}  // namespace

const Model& DemoLayout::model(const std::string& file) const {
  for (const DemoModel& m : models)
    if (m.file == file) return m.model;
  throw Error(Error::Kind::BadInput, "the demo '%1' has no model '%2'", name, file);
}

std::vector<std::string> demo_names() {
  std::vector<std::string> names;
  for (const auto& [name, make] : kMakers) names.emplace_back(name);
  return names;
}

DemoLayout make_demo(const std::string& name) {
  std::string accepted;
  for (const auto& [known, make] : kMakers) {
    if (name == known) return make();
    accepted += (accepted.empty() ? "" : ", ") + std::string(known);
  }
  throw Error(Error::Kind::BadInput, "no demo '%1'; there are %2", name, accepted);
}

std::string layout_json(const DemoLayout& demo) { return write_layout(demo.layout) + "\n"; }

}  // namespace trivet
