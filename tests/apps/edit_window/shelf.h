// A shelf filled by pointing into it, and seen by sections.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// @param folder  for models.
void fill_shelf(Document& document, MainWindow& window, User& user, const QString& folder);
/// Leaves a book under a board.
void look_under_a_shelf(Document& document, MainWindow& window, User& user, const QString& folder);

}  // namespace trivet::edit::test
