// Operations on the active object, as started by tools and panels.
#pragma once

#include <type_traits>
#include <utility>

#include "apps/edit/document/selection.h"
#include "apps/edit/tools/tool.h"
#include "ops/placement/neighbourhood.h"

namespace trivet::edit {

/// Operation on the active object; the other selected objects move along if they can.
template <class T>
T operation_of(const Object& object, const Document& document, const ToolOptions& options) {
  T operation;
  operation.object = object.name;
  operation.settle_left = options.settle_left;
  if constexpr (std::is_base_of_v<JointMoveOptions, T>)
    operation.together = selected_beside_active(document.selection(), *document.snapshot());
  return operation;
}

/// Heights of the steps that a PUSH goes up and down, metres.
inline std::pair<double, double> push_steps(const ToolOptions& options, const Object& object) {
  if (!options.steps_by_size) return {options.step_up, options.step_down};
  const double step = options.step_share * size_of(object);
  return {step, step};
}

}  // namespace trivet::edit
