// Operations on the active object, as started by tools and panels.
#pragma once

#include <tuple>
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

/// Keys of the thresholds that the operation panel shows.
inline constexpr const char* kPushSteps[] = {"step_up", "step_down"};

/// Heights of the steps that a PUSH goes up and down, metres.
inline std::pair<double, double> push_steps(const ToolOptions& options, const Object& object) {
  if (!options.steps_by_size) return {options.push.step_up, options.push.step_down};
  const double step = options.step_share * size_of(object);
  return {step, step};
}

/// Thresholds of a PUSH as the panel has them.
inline void set_push_options(const ToolOptions& options, const Object& object,
                             PushOperation& push) {
  std::tie(push.step_up, push.step_down) = push_steps(options, object);
  push.slide = options.slide;
  push.settle = options.settle;
}

}  // namespace trivet::edit
