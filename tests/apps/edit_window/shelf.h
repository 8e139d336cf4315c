// A shelf filled by pointing into it.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// @param folder  for models.
void fill_shelf(Document& document, MainWindow& window, User& user, const QString& folder);

}  // namespace trivet::edit::test
