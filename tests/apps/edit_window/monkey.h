// Simulated user who clicks, drags and types at random in the editor's window.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Runs some hundreds of actions (times TRIVET_TEST_EFFORT) and prints the seed: every commit must
/// be sound, and undoing all must restore the start bit for bit. Leaves the document at its first
/// step, without unsaved changes.
void play_monkey(Document& document, MainWindow& window, User& user);

/// On the scene that is there, and prints the response of its drags alone.
void measure_monkey(Document& document, MainWindow& window, User& user, int num_actions);

}  // namespace trivet::edit::test
