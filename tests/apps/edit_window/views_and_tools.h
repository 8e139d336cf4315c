// Bookmarks, snapping, painting and PUSH along walls in the window.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// In the scene that look_under_a_shelf() left. @param folder  for files.
void keep_views(Document& document, MainWindow& window, User& user, const QString& folder);
void snap_and_paint(Document& document, MainWindow& window, User& user, const QString& folder);
void push_along_a_wall(Document& document, MainWindow& window, User& user, const QString& folder);

}  // namespace trivet::edit::test
