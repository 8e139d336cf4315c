// Mouse and keyboard of a view: its camera, its section, and events for the tools.
#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "apps/edit/window/key_events.h"
#include "apps/edit/window/scene_view.h"

namespace trivet::edit {
namespace {

constexpr double kClickPx = 4;      // allowed motion of the mouse in a click
constexpr double kZoomDragPx = 30;  // of dragging, per step of the wheel
constexpr double kCutPx = 12;       // by which a step of the wheel moves the section

Qt::CursorShape shape_of(Cursor cursor) {
  switch (cursor) {
    case Cursor::Cross:
      return Qt::CrossCursor;
    case Cursor::OpenHand:
      return Qt::OpenHandCursor;
    case Cursor::ClosedHand:
      return Qt::ClosedHandCursor;
    case Cursor::Forbidden:
      return Qt::ForbiddenCursor;
    case Cursor::Busy:
      return Qt::BusyCursor;
    case Cursor::Arrow:
      break;
  }
  return Qt::ArrowCursor;
}

}  // namespace

SceneView::CameraDrag SceneView::camera_drag_of(const QMouseEvent& event) const {
  const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
  const bool control = event.modifiers().testFlag(Qt::ControlModifier);
  const bool alt = event.modifiers().testFlag(Qt::AltModifier);
  const CameraDrag turn = m_camera.is_orthographic() ? CameraDrag::Pan : CameraDrag::Orbit;
  if (event.button() == Qt::MiddleButton || (alt && event.button() == Qt::LeftButton))
    return shift ? CameraDrag::Pan : control ? CameraDrag::Zoom : turn;
  if (event.button() == Qt::RightButton) return alt ? CameraDrag::Zoom : CameraDrag::Pan;
  return CameraDrag::None;
}

bool SceneView::send(PointerEvent::Kind kind, const QMouseEvent& event) {
  PointerEvent out;
  out.kind = kind;
  out.px = Vec2(event.position().x(), event.position().y());
  out.button = kind == PointerEvent::Kind::Move ? MouseButton::None : button_of(event.button());
  out.left_is_down = event.buttons().testFlag(Qt::LeftButton);
  out.modifiers = modifiers_of(event.modifiers());
  out.window = m_kind;
  out.view = view();
  const bool taken = m_toolbox.pointer(out);
  update_cursor();
  Q_EMIT pointed();
  return taken;
}

void SceneView::update_cursor() { setCursor(shape_of(m_toolbox.cursor())); }

void SceneView::mousePressEvent(QMouseEvent* event) {
  m_last_position = m_pressed_at = event->position();
  m_camera_drag = camera_drag_of(*event);
  if (m_camera_drag == CameraDrag::None) send(PointerEvent::Kind::Press, *event);
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF moved = event->position() - m_last_position;
  m_last_position = event->position();
  if (m_camera_drag == CameraDrag::None) {
    send(PointerEvent::Kind::Move, *event);
  } else {
    move_camera(moved);
  }
}

void SceneView::move_camera(const QPointF& moved_px) {
  switch (m_camera_drag) {
    case CameraDrag::Orbit:
      m_camera.orbit(moved_px);
      break;
    case CameraDrag::Pan:
      m_camera.pan(moved_px, size());
      break;
    case CameraDrag::Zoom:
      m_camera.zoom(-moved_px.y() / kZoomDragPx, m_pressed_at, size());
      break;
    case CameraDrag::None:
      return;
  }
  Q_EMIT camera_moved();
  redraw();
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  const bool was_camera = m_camera_drag != CameraDrag::None;
  m_camera_drag = CameraDrag::None;
  if (!was_camera) {
    send(PointerEvent::Kind::Release, *event);
    return;
  }
  const QPointF moved = event->position() - m_pressed_at;
  const bool is_click = std::hypot(moved.x(), moved.y()) <= kClickPx;
  if (is_click && event->button() == Qt::RightButton)
    Q_EMIT context_menu_wanted(event->globalPosition().toPoint());
  if (is_click && event->button() == Qt::LeftButton) {  // Alt-click belongs to the tool
    send(PointerEvent::Kind::Press, *event);
    send(PointerEvent::Kind::Release, *event);
  }
  redraw();
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (camera_drag_of(*event) == CameraDrag::None) send(PointerEvent::Kind::DoubleClick, *event);
}

bool SceneView::turn_in_hand(const QWheelEvent& event) {
  PointerEvent out;
  out.kind = PointerEvent::Kind::Wheel;
  out.px = Vec2(event.position().x(), event.position().y());
  out.wheel_steps = event.angleDelta().y() / 120.0;
  out.left_is_down = event.buttons().testFlag(Qt::LeftButton);
  out.modifiers = modifiers_of(event.modifiers());
  out.window = m_kind;
  out.view = view();
  const bool taken = m_toolbox.pointer(out);
  if (taken) Q_EMIT pointed();
  return taken;
}

// The wheel turns what is in the hand. With Control it moves the section.
void SceneView::wheelEvent(QWheelEvent* event) {
  if (event->modifiers().testFlag(Qt::ControlModifier) && m_section.on) {
    const View now = view();
    const double metres = now.metres_per_px(std::max(now.depth(now.target), 0.0));
    m_section.shift += kCutPx * metres * event->angleDelta().y() / 120.0;
    return redraw();
  }
  if (turn_in_hand(*event)) return;
  m_camera.zoom(event->angleDelta().y() / 120.0, event->position(), size());
  m_camera_moved.start();
  Q_EMIT camera_moved();
  redraw();
}

// Keys act on the view under the pointer.
void SceneView::enterEvent(QEnterEvent*) {
  if (!takes_text(QApplication::focusWidget())) setFocus(Qt::MouseFocusReason);
}

void SceneView::leaveEvent(QEvent*) {
  PointerEvent out;
  out.kind = PointerEvent::Kind::Leave;
  out.window = m_kind;
  out.view = view();
  m_toolbox.pointer(out);
  Q_EMIT pointed();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  const KeyEvent key = key_event_of(*event);
  if (!has_meaning(key) || !m_toolbox.key(key)) QWidget::keyPressEvent(event);
  update_cursor();
  Q_EMIT pointed();
}

// Tab belongs to the tool during a drag.
bool SceneView::focusNextPrevChild(bool next) {
  return !m_toolbox.tool().is_active() && QWidget::focusNextPrevChild(next);
}

}  // namespace trivet::edit
