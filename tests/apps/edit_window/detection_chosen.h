// Detection: chosen in Preferences, named in the status bar, kept in the settings.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Framebuffers are chosen, and a new window with what is saved drags a teapot with them, to the
/// poses of BVHs. @param recovery  a folder of that window's document.
void choose_framebuffers(Document& document, MainWindow& window, User& user,
                         const QString& recovery);

}  // namespace trivet::edit::test
