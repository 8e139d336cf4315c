// A judge of windows: a hand has to reach all that they show.
#pragma once

#include <QStringList>
#include <QWidget>

namespace trivet::edit::test {

/// Controls of a window that are cut off, covered or squeezed; and tool bars that do not show all
/// of their tools. What scrolls up and down is reached by scrolling.
QStringList out_of_reach(const QWidget& window);

/// The same of a dialog, and whether it is on the screen as a whole.
QStringList out_of_screen(const QWidget& dialog);

}  // namespace trivet::edit::test
