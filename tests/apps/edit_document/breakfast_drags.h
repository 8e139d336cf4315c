// Drags in BREAKFAST that are the same whoever detects, and the poses that are seen in them.
#pragma once

#include <QStringList>

#include "apps/edit_document/hand.h"

namespace trivet::edit::test {

/// Poses of all that moves, of every snapshot of every drag, one after another.
using Poses = std::vector<double>;

void append(const Pose& pose, Poses& out);

BackendOptions backend(Backend which);

/// BREAKFAST in a document, and a mouse.
struct Table {
  explicit Table(BackendOptions detection = {});

  /// In eight moves, each of which is followed.
  void drag(const std::string& name, const Vec2& way);
  /// Pushed until something stops it, moved through the air, and turned.
  void drag_several();

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
  Poses poses;
  QStringList notes;  // on detection
};

/// Poses after drag_several().
const Poses& poses_of_bvhs();

}  // namespace trivet::edit::test
