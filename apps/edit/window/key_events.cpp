#include "apps/edit/window/key_events.h"

#include <QAbstractSpinBox>
#include <QLineEdit>

namespace trivet::edit {

Modifiers modifiers_of(Qt::KeyboardModifiers keys) {
  return {keys.testFlag(Qt::ShiftModifier), keys.testFlag(Qt::ControlModifier),
          keys.testFlag(Qt::AltModifier)};
}

MouseButton button_of(Qt::MouseButton button) {
  return button == Qt::LeftButton     ? MouseButton::Left
         : button == Qt::MiddleButton ? MouseButton::Middle
         : button == Qt::RightButton  ? MouseButton::Right
                                      : MouseButton::None;
}

KeyEvent key_event_of(const QKeyEvent& event) {
  KeyEvent out;
  out.modifiers = modifiers_of(event.modifiers());
  switch (event.key()) {
    case Qt::Key_Escape:
      out.key = KeyEvent::Key::Escape;
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      out.key = KeyEvent::Key::Return;
      break;
    case Qt::Key_Delete:
      out.key = KeyEvent::Key::Delete;
      break;
    case Qt::Key_Tab:
      out.key = KeyEvent::Key::Tab;
      break;
    case Qt::Key_Backspace:
      out.key = KeyEvent::Key::Backspace;
      break;
    default: {
      const QString text = event.text().toLower();
      if (text.size() == 1) out.character = text[0].toLatin1();
    }
  }
  return out;
}

bool takes_text(const QWidget* widget) {
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget);
}

}  // namespace trivet::edit
