// The end of a gesture that a ghost shows.
#pragma once

#include "apps/edit/document/document.h"

namespace trivet::edit {

/// Commits what the ghost shows, as one step; where it does not answer yet, the first of the
/// choices that is done. The drag in progress ends with it.
/// @param start  the object as it was. @return false: nothing would move, and nothing is done.
bool put_as_shown(Document& document, ObjectId object, const Object& start,
                  std::vector<Operation> choices);

}  // namespace trivet::edit
