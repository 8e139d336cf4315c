// Light and dark theme: colours of the windows and of the scene.
#pragma once

#include <QColor>
#include <QString>

#include "gpu/live/scene.h"

class QApplication;

namespace trivet::edit {

struct Theme {
  bool dark = true;

  LiveTheme scene() const { return dark ? LiveTheme::dark() : LiveTheme::light(); }
  QColor text() const { return dark ? QColor(222, 224, 228) : QColor(32, 35, 40); }
  QColor faint_text() const { return dark ? QColor(150, 155, 163) : QColor(104, 110, 120); }
  QColor window() const { return dark ? QColor(43, 45, 49) : QColor(238, 239, 241); }
  QColor base() const { return dark ? QColor(33, 35, 38) : QColor(252, 252, 253); }
  QColor line() const { return dark ? QColor(28, 29, 32) : QColor(205, 208, 213); }
  QColor accent() const { return dark ? QColor(86, 146, 226) : QColor(38, 108, 200); }
  QColor refused() const { return dark ? QColor(224, 96, 84) : QColor(196, 52, 40); }
  QColor warning() const { return dark ? QColor(230, 168, 60) : QColor(190, 120, 10); }
  QColor information() const { return accent(); }
  QColor lit() const { return QColor(255, 64, 40); }  // interfering faces
  // Colours of pairs of faces in the z-list view, also for the colour-blind [Okabe 2008].
  QColor moving_face() const { return QColor(230, 159, 0); }
  QColor fixed_face() const { return QColor(86, 180, 233); }

  /// Style, palette and style sheet of the whole program.
  void apply(QApplication& application) const;
};

/// With alpha, for the scene.
LiveColour live_colour(const QColor& colour, float alpha = 1);

}  // namespace trivet::edit
