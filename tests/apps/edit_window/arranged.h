// Arranging by the dock, in a real window.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// @param folder  for models.
void arrange_by_wishes(Document& document, MainWindow& window, User& user, const QString& folder);

}  // namespace trivet::edit::test
