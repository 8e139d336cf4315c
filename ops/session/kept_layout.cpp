#include "ops/session/kept_layout.h"

#include <algorithm>

#include "ops/files/layout/named_objects.h"

namespace trivet {
namespace {

// True if all objects that there ever were are of files, or copies of such.
bool is_of_files(const Layout& layout, const Scene& scene) {
  NamedObjects known(layout.objects);
  for (const Operation& operation : layout.operations) {
    const auto* const append = std::get_if<AppendOperation>(&operation);
    if ((append && append->model.empty()) || !known.follow(operation)) return false;
  }
  const std::vector<ObjectId> ids = scene.ids();
  return std::all_of(ids.begin(), ids.end(),
                     [&](ObjectId id) { return known.contains(scene.at(id).name); });
}

}  // namespace

Layout kept_layout(const Session& session, const SettleOptions& settle) {
  Layout layout = session.layout();
  if (!is_of_files(layout, session.scene())) {
    layout = Layout{};
    layout.floor = session.scene().floor;
  }
  layout.settle = rules_of(settle);
  return layout;
}

}  // namespace trivet
