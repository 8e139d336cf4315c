// A drawer opened and closed by its slider in the properties.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// @param folder  for models.
void open_a_drawer(Document& document, MainWindow& window, User& user, const QString& folder);

}  // namespace trivet::edit::test
