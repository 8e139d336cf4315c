// Icons, drawn from paths in the text colour: sharp at every size, in both themes.
#pragma once

#include <QColor>
#include <QIcon>

namespace trivet::edit {

enum class Icon {
  Select,
  Put,
  Push,
  Turn,
  PickUp,
  Move,
  Rotate,
  Paint,
  Drape,  // tools, in the order of ToolKind
  New,
  Open,
  Save,
  Import,
  Picture,
  Undo,
  Redo,
  Frame,
  Maximise,
  Snap,
  Stable,
  Fixed,
  Held,
  Unsupported,
  Invalid,
  Unplaced,
  Wedged,  // states
};

QIcon make_icon(Icon icon, const QColor& colour);
/// A trivet: three legs under a ring.
QIcon application_icon();

}  // namespace trivet::edit
