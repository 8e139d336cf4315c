// Tour of the windows: full scenes at every size, tabs, tools, dialogs, menus.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Pictures "breakfast_...", "start_...". The scene is BREAKFAST.
void look_at_full_scenes(Document& document, MainWindow& window, User& user);

/// Pictures "spoon_...", "tool_...", "dialog_...", "menu_...". Leaves no unsaved changes.
void look_at_dialogs_and_menus(Document& document, MainWindow& window, User& user);

}  // namespace trivet::edit::test
