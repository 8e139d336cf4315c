// Operations on the active object, as started by tools and panels.
#pragma once

#include <type_traits>

#include "apps/edit/document/selection.h"
#include "apps/edit/tools/tool.h"

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

}  // namespace trivet::edit
