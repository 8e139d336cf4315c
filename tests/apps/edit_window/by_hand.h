// Things laid out by hand, without a tool: what it takes of clicks, drags and keys.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Prints the effort of each job. Leaves no unsaved changes.
/// @param folder  for the models.
void lay_out_by_hand(Document& document, MainWindow& window, User& user, const QString& folder);

}  // namespace trivet::edit::test
