// Several objects moved at once, and a fixed table with its loads.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Pictures "together_...", "table_freed". The scene is BREAKFAST; it is restored.
void move_several(Document& document, MainWindow& window, User& user);

}  // namespace trivet::edit::test
