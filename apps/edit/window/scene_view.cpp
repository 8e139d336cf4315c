#include "apps/edit/window/scene_view.h"

#include <QColor>
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPen>
#include <QResizeEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "apps/edit/window/key_events.h"
#include "apps/edit/window/wish_marks.h"

namespace trivet::edit {
namespace {

constexpr int kCalmMs = 140;  // without motion, until a draft is replaced by a full picture
constexpr double kSlowDraftMs = 40, kQuickDraftMs = 9;
constexpr int kCoarsest = 3;

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

View SceneView::view() const {
  View out = m_camera.view(size());
  out.cut = m_cut;
  return out;
}

void SceneView::set_section(const Section& section) {
  if (section == m_section) return;
  m_section = section;
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
  m_cut = section_depth(*m_document.snapshot(), m_document.selection(), m_camera.view(size()),
                        m_section, m_document.looks().hidden());
  request.scene = m_drawing.scene(view());
  request.camera = m_camera.camera();
  request.camera.cut = m_cut;
  LiveOptions& options = request.options;
  options.draft = m_requested_draft = is_in_motion();
  options.coarse = options.draft && camera_moves();
  const int coarse = options.draft ? coarseness() : 1;
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

int& SceneView::coarseness() { return camera_moves() ? m_camera_coarseness : m_coarseness; }

void SceneView::take(int view, quint64 number, const QImage& image, double milliseconds,
                     bool whole) {
  if (view != static_cast<int>(m_kind)) return;
  m_waiting = false;
  m_image = image;
  m_shown = number;
  m_shown_is_draft = m_requested_draft;
  m_picture_ms = milliseconds;
  if (m_shown_is_draft) {
    int& coarse = coarseness();
    if (milliseconds > kSlowDraftMs && whole) coarse = std::min(coarse + 1, kCoarsest);
    if (milliseconds < kQuickDraftMs && whole) coarse = std::max(coarse - 1, 1);
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
  paint_at_pointer(painter);
  paint_section(painter);
  paint_wishes(m_document, m_drawing.theme(), view(), painter.fontMetrics(),
               [&](const QRectF& box, const QString& text, const QColor& colour) {
                 paint_label(painter, box, Qt::AlignCenter, text, colour);
               });
  if (hasFocus()) {
    painter.setPen(QPen(theme.accent(), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void SceneView::resizeEvent(QResizeEvent*) { redraw(); }

bool SceneView::event(QEvent* event) {
  if (event->type() == QEvent::Show || event->type() == QEvent::ScreenChangeInternal) redraw();
  // Numbers that are typed during a drag are no shortcuts.
  if (event->type() == QEvent::ShortcutOverride &&
      m_toolbox.wants_key(key_event_of(*static_cast<QKeyEvent*>(event)))) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

}  // namespace trivet::edit
