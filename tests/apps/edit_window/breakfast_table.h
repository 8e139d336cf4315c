// apps/README.md, "A breakfast table in two minutes", step by step, by mouse and keyboard.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Takes that page's pictures "table_...". Leaves no unsaved changes.
/// @param folder  for the models.
void lay_breakfast_table(Document& document, MainWindow& window, User& user, const QString& folder);

}  // namespace trivet::edit::test
