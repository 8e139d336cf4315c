// Steps of a run, for programs that hold their models and do operations of their own in between.
#pragma once

#include <map>
#include <string>

#include "ops/files/layout/run.h"

namespace trivet {

using LoadedModels = std::map<ModelRequest, LoadedModel>;

/// Requests for the models of the objects, in the order in which objects first name them.
std::vector<ModelRequest> model_requests(const Layout& layout);

/// Objects of the layout, all of them out of the scene yet.
/// @param models  all that model_requests() names.
/// @throws Error (BadInput) for an object that reaches beyond kMaxLength.
Scene make_scene(const Layout& layout, const LoadedModels& models, const std::string& layout_file);

/// Places the objects to which the layout gives poses; records refusals.
void stand_objects(const Layout& layout, const RunOptions& options, LayoutRun& run);

}  // namespace trivet
