// Exact numbers, many objects at once, and how objects are shown, in the window.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Leaves a tray with an apple. @param folder  for models.
void work_by_numbers(Document& document, MainWindow& window, User& user, const QString& folder);
/// Begins with the tray and the apple.
void lay_out_many(Document& document, MainWindow& window, User& user);
/// Begins with the tray full of apples.
void show_and_hide(Document& document, MainWindow& window, User& user);

}  // namespace trivet::edit::test
