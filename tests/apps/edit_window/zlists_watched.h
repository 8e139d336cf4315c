// The z-list view during a drag and over a support, in both themes; who answers.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// During a drag that something stops: doubtful pixels are outlined, in both themes.
void look_at_doubtful_pixels(Document& document, MainWindow& window, User& user);

void look_at_zlists(Document& document, MainWindow& window, User& user);

}  // namespace trivet::edit::test
