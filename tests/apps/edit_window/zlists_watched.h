// The z-list view during a drag and over a support, in both themes; who answers.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

void look_at_zlists(Document& document, MainWindow& window, User& user);

}  // namespace trivet::edit::test
