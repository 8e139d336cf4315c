// Qt's mouse and key events as those of the tools.
#pragma once

#include <QKeyEvent>
#include <QWidget>

#include "apps/edit/tools/events.h"

namespace trivet::edit {

Modifiers modifiers_of(Qt::KeyboardModifiers keys);
MouseButton button_of(Qt::MouseButton button);
/// A key without meaning gives Key::Character with character 0.
KeyEvent key_event_of(const QKeyEvent& event);
inline bool has_meaning(const KeyEvent& event) {
  return event.key != KeyEvent::Key::Character || event.character != 0;
}

/// True if keys are text for this widget: a line or a number that is edited. Null: false.
bool takes_text(const QWidget* widget);

}  // namespace trivet::edit
