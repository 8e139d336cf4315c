// Somebody who clicks, drags and types at random in the editor's window.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Some hundreds of actions (times TRIVET_TEST_EFFORT), with the seed printed: whatever is
/// committed is sound, undoing all brings back the first bit. The document has nothing unsaved, and
/// is at its first step when this is done.
void play_monkey(Document& document, MainWindow& window, User& user);

}  // namespace trivet::edit::test
