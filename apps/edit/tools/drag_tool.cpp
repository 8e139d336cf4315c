#include "apps/edit/tools/drag_tool.h"

namespace trivet::edit {
namespace {

constexpr double kClickPx = 3;  // a press with less motion is a click

}  // namespace

bool DragTool::pointer(const PointerEvent& event) {
  using Kind = PointerEvent::Kind;
  if (event.kind == Kind::Press) {
    if (m_pressed) return true;
    if (event.button != MouseButton::Left || m_document.is_busy() || !grab(event)) return false;
    m_pressed = event;
    m_is_drag = false;
    return true;
  }
  if (!m_pressed) {
    if (event.kind == Kind::Move) hover(event);
    return false;
  }
  if (event.kind == Kind::Move) {
    if (!m_is_drag && (event.px - m_pressed->px).norm() > kClickPx) {
      if (const auto operation = begin()) {
        m_document.begin_drag(*operation);
        m_is_drag = true;
        m_typed = numbers();
      }
    }
    if (m_is_drag && m_document.is_dragging() && m_typed.empty()) steer(event);
    return true;
  }
  if (event.kind != Kind::Release || event.button != MouseButton::Left) return true;
  if (m_is_drag) {
    finish_drag();
    return true;
  }
  if (!m_document.is_busy()) click(event);
  m_pressed.reset();
  return true;
}

void DragTool::finish_drag() {
  m_is_drag = false;
  m_pressed.reset();
  m_document.end_drag();
}

// --- numbers -----------------------------------------------------------------------------------

bool DragTool::wants_key(const KeyEvent& event) const {
  if (!m_is_drag || !m_typed.takes_numbers()) return false;
  if (event.key == KeyEvent::Key::Character) return TypedNumbers::is_part(event.character);
  return event.key == KeyEvent::Key::Tab || event.key == KeyEvent::Key::Backspace ||
         event.key == KeyEvent::Key::Return;
}

bool DragTool::type(const KeyEvent& event) {
  if (!wants_key(event)) return false;
  if (event.key == KeyEvent::Key::Return) {
    finish_drag();
    return true;
  }
  if (event.key == KeyEvent::Key::Tab)
    m_typed.next_axis();
  else if (event.key == KeyEvent::Key::Backspace)
    m_typed.erase();
  else
    m_typed.type(event.character);
  if (m_document.is_dragging()) steer_by(m_typed.values());
  return true;
}

std::string DragTool::reading() const {
  if (!m_is_drag || m_typed.empty()) return {};
  return m_typed.text() + "  –  Tab: next axis, Return: done, Escape: cancel";
}

bool DragTool::key(const KeyEvent& event) {
  if (type(event)) return true;
  if (event.key != KeyEvent::Key::Escape) return false;
  if (m_pressed) {
    cancel();
    return true;
  }
  if (m_document.selection() == Selection()) return false;
  m_document.select({});
  return true;
}

void DragTool::cancel() {
  if (m_is_drag) m_document.cancel_drag();
  m_is_drag = false;
  m_pressed.reset();
}

Cursor DragTool::cursor() const {
  if (!m_pressed) return Cursor::OpenHand;
  const auto& drag = scene().drag;
  return m_is_drag && drag && drag->blocked ? Cursor::Forbidden : Cursor::ClosedHand;
}

const ObjectSnapshot* DragTool::active() const {
  const auto id = m_document.selection().active();
  return id ? scene().find(*id) : nullptr;
}

const ObjectSnapshot* DragTool::grab_object(const PointerEvent& event) {
  const Selection& selection = m_document.selection();
  const auto picked = pick_to_drag(scene(), event.view, event.px, selection.objects,
                                   m_document.looks().not_selectable());
  if (!picked || !picked->object) return nullptr;
  if (!selection.contains(*picked->object)) {
    m_document.select_only(picked->object);
  } else if (selection.active() != picked->object) {
    Selection turned{selection.objects, {}};
    std::erase(turned.objects, *picked->object);
    turned.objects.push_back(*picked->object);
    m_document.select(std::move(turned));
  }
  m_grabbed_at = picked->point;
  return active();
}

}  // namespace trivet::edit
