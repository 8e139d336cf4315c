// Operations on the active object, as tools and panels begin them.
#pragma once

#include <type_traits>

#include "apps/edit/document/selection.h"
#include "apps/edit/tools/tool.h"

namespace trivet::edit {

/// An operation on an object that is active; what else is selected moves along, if it can be moved
/// together.
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
