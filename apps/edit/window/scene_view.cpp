#include "apps/edit/window/scene_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace trivet::edit {
namespace {

constexpr int kCalmMs = 140;  // without motion, until a draft is replaced by a full picture
constexpr double kSlowDraftMs = 40, kQuickDraftMs = 9;
constexpr int kCoarsest = 3;
constexpr double kClickPx = 4;      // allowed motion of the mouse in a click
constexpr double kZoomDragPx = 30;  // of dragging, per step of the wheel

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

SceneView::SceneView(WindowKind kind, Document& document, Toolbox& toolbox, SceneDrawing& drawing,
                     Painter& painter, QWidget* parent)
    : QWidget(parent),
      m_kind(kind),
      m_document(document),
      m_toolbox(toolbox),
      m_drawing(drawing),
      m_painter(painter),
      m_camera(ViewCamera::perspective()) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(120, 80);
  setAttribute(Qt::WA_OpaquePaintEvent);
  m_calm.setSingleShot(true);
  m_calm.setInterval(kCalmMs);
  connect(&m_calm, &QTimer::timeout, this, &SceneView::redraw);
  connect(&m_drawing, &SceneDrawing::changed, this, &SceneView::redraw);
  connect(&m_painter, &Painter::painted, this, &SceneView::take);
  connect(&m_painter, &Painter::failed, this, [this](const QString& why) {
    m_failure = why;
    update();
  });
}

// --- drawing -----------------------------------------------------------------------------------

void SceneView::set_camera(const ViewCamera& camera) {
  m_camera = camera;
  redraw();
}

void SceneView::frame(const Aabb& box) {
  m_camera.frame(box, size());
  redraw();
}

Aabb SceneView::selected_box() const {
  const auto snapshot = m_document.snapshot();
  Aabb box;
  for (const ObjectId id : m_document.selection().objects)
    if (const ObjectSnapshot* const object = snapshot->find(id); object && (*object)->placed)
      box.extend(world_box(*object->object));
  return box.empty() ? snapshot->box() : box;
}

bool SceneView::camera_moves() const {
  return m_camera_drag != CameraDrag::None ||
         (m_camera_moved.isValid() && m_camera_moved.elapsed() < kCalmMs);
}

bool SceneView::is_in_motion() const { return camera_moves() || m_drawing.is_moving(); }

void SceneView::redraw() {
  ++m_wanted;
  request();
}

void SceneView::follow_tool() {
  std::vector<double> lines;
  for (const Overlay::Line& line : m_toolbox.overlay(view()).lines) {
    lines.insert(lines.end(), {double(line.role), double(line.axis)});
    lines.insert(lines.end(), line.a.begin(), line.a.end());
    lines.insert(lines.end(), line.b.begin(), line.b.end());
  }
  if (lines == m_tool_lines) return update();  // rubber bands are painted over the picture
  m_tool_lines = std::move(lines);
  redraw();
}

void SceneView::request() {
  if (m_waiting || !isVisible() || width() < 1 || height() < 1) return;
  PaintRequest request;
  request.view = static_cast<int>(m_kind);
  request.number = m_requested = m_wanted;
  request.scene = m_drawing.scene(view());
  request.camera = m_camera.camera();
  LiveOptions& options = request.options;
  options.draft = m_requested_draft = is_in_motion();
  options.coarse = options.draft && camera_moves();
  const int coarse = options.draft ? m_coarseness : 1;
  const double ratio = devicePixelRatioF() / coarse;
  options.width = std::max(static_cast<int>(std::lround(width() * ratio)), 1);
  options.height = std::max(static_cast<int>(std::lround(height() * ratio)), 1);
  options.pixel_ratio = ratio;
  options.theme = m_drawing.theme().scene();
  options.shadows = m_drawing.options().shadows;
  options.view = request.view;
  m_waiting = true;
  m_painter.paint(std::move(request));
}

void SceneView::take(int view, quint64 number, const QImage& image, double milliseconds,
                     bool once) {
  if (view != static_cast<int>(m_kind)) return;
  m_waiting = false;
  m_image = image;
  m_shown = number;
  m_shown_is_draft = m_requested_draft;
  m_picture_ms = milliseconds;
  if (m_shown_is_draft) {
    if (milliseconds > kSlowDraftMs && !once) m_coarseness = std::min(m_coarseness + 1, kCoarsest);
    if (milliseconds < kQuickDraftMs) m_coarseness = std::max(m_coarseness - 1, 1);
    m_calm.start();
  }
  update();
  if (m_shown != m_wanted) request();
}

void SceneView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Theme& theme = m_drawing.theme();
  if (m_image.isNull() || !m_failure.isEmpty()) {
    painter.fillRect(rect(), theme.base());
    painter.setPen(theme.faint_text());
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     m_failure.isEmpty() ? QString() : tr("Cannot draw: %1").arg(m_failure));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform, m_shown_is_draft);
  painter.drawImage(rect(), m_image);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_axes(painter);
  paint_scale(painter);
  paint_rubber_band(painter);
  if (hasFocus()) {
    painter.setPen(QPen(theme.accent(), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

/// Readable over any background.
void SceneView::paint_label(QPainter& painter, const QRectF& box, int flags, const QString& text,
                            const QColor& colour) const {
  painter.setPen(m_drawing.theme().base());
  for (const QPointF& aside : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1)})
    painter.drawText(box.translated(aside), flags, text);
  painter.setPen(colour);
  painter.drawText(box, flags, text);
}

void SceneView::paint_axes(QPainter& painter) const {
  constexpr double kLength = 22, kRoom = 34;
  const QColor colours[3] = {{214, 76, 76}, {96, 168, 66}, {72, 122, 222}};
  const View::Axes axes = view().axes();
  const QPointF origin(kRoom, height() - kRoom);
  for (int i = 0; i < 3; ++i) {
    const QPointF along(axes.right[i], -axes.up[i]);
    if (std::hypot(along.x(), along.y()) < 0.08) continue;
    painter.setPen(QPen(colours[i], 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(origin, origin + kLength * along);
    const QPointF label = origin + (kLength + 8) * along;
    paint_label(painter, QRectF(label - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter,
                QString("XYZ").mid(i, 1), colours[i]);
  }
}

void SceneView::paint_scale(QPainter& painter) const {
  if (!m_camera.is_orthographic() || width() < 220) return;
  const double metres_per_px = view().metres_per_px(1);
  double metres = std::pow(10, std::floor(std::log10(110 * metres_per_px)));
  for (const double factor : {5.0, 2.0})
    if (factor * metres / metres_per_px <= 110) {
      metres *= factor;
      break;
    }
  const double length = metres / metres_per_px;
  const QString text = metres >= 1      ? tr("%1 m").arg(metres)
                       : metres >= 0.01 ? tr("%1 cm").arg(100 * metres)
                                        : tr("%1 mm").arg(1000 * metres);
  const QPointF right(width() - 14, height() - 14), left = right - QPointF(length, 0);
  for (const QPen& pen :
       {QPen(m_drawing.theme().base(), 3.2), QPen(m_drawing.theme().text(), 1.2)}) {
    painter.setPen(pen);
    painter.drawLine(left, right);
    for (const QPointF& end : {left, right}) painter.drawLine(end - QPointF(0, 4), end);
  }
  paint_label(painter, QRectF(left - QPointF(40, 22), right + QPointF(40, -4)),
              Qt::AlignHCenter | Qt::AlignBottom, text, m_drawing.theme().text());
}

void SceneView::paint_rubber_band(QPainter& painter) const {
  const Overlay overlay = m_toolbox.overlay(view());
  if (!overlay.box_px || overlay.box_window != m_kind) return;
  const auto& [a, b] = *overlay.box_px;
  const QColor accent = m_drawing.theme().accent();
  QColor fill = accent;
  fill.setAlpha(40);
  painter.setPen(QPen(accent, 1));
  painter.setBrush(fill);
  painter.drawRect(QRectF(QPointF(a.x(), a.y()), QPointF(b.x(), b.y())).normalized());
}

void SceneView::resizeEvent(QResizeEvent*) { redraw(); }

bool SceneView::event(QEvent* event) {
  if (event->type() == QEvent::Show || event->type() == QEvent::ScreenChangeInternal) redraw();
  return QWidget::event(event);
}

// --- mouse and keyboard ------------------------------------------------------------------------

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

void SceneView::wheelEvent(QWheelEvent* event) {
  m_camera.zoom(event->angleDelta().y() / 120.0, event->position(), size());
  m_camera_moved.start();
  Q_EMIT camera_moved();
  redraw();
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
  KeyEvent out;
  out.modifiers = modifiers_of(event->modifiers());
  switch (event->key()) {
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
    default: {
      const QString text = event->text().toLower();
      if (text.size() == 1) out.character = text[0].toLatin1();
    }
  }
  const bool has_meaning = out.key != KeyEvent::Key::Character || out.character != 0;
  if (!has_meaning || !m_toolbox.key(out)) QWidget::keyPressEvent(event);
  update_cursor();
  Q_EMIT pointed();
}

}  // namespace trivet::edit
