// Display of blocked drags, of interpenetrating objects, and of settling.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Pictures "blocked_...", "crossing_...". The scene is BREAKFAST; it is restored.
void look_at_interference(Document& document, MainWindow& window, User& user);

/// Pictures "settling_...". The same.
void watch_settling(Document& document, MainWindow& window, User& user);

}  // namespace trivet::edit::test
