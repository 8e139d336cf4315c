// Cloths and cables in the window.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Over the fruit of BREAKFAST: it is seen as it comes down, stopped, done and undone.
void drape_a_napkin(Document& document, MainWindow& window, User& user);
/// From a lamp to a socket, by clicks; then the lamp is pushed. @param folder  for files.
void lay_a_lead(Document& document, MainWindow& window, User& user, const QString& folder);

}  // namespace trivet::edit::test
