// Marks of a view over its picture: axes, scale, rubber band, the reason of a refusal.
#include <QColor>
#include <QPainter>
#include <QPen>
#include <algorithm>
#include <cmath>

#include "apps/edit/window/scene_view.h"

namespace trivet::edit {

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

void SceneView::paint_section(QPainter& painter) const {
  if (!m_section.on || (m_section.only_if_hidden && m_section.shift == 0 && !m_cut)) return;
  const auto active = m_document.selection().active();
  const ObjectSnapshot* const object = active ? m_document.snapshot()->find(*active) : nullptr;
  const QString text =
      object && (*object)->placed
          ? tr("Cut away in front of %1").arg(QString::fromStdString((*object)->name))
          : tr("Cut away in front of the middle");
  paint_label(painter, QRectF(12, 8, width() - 24, 20), Qt::AlignLeft | Qt::AlignTop,
              m_cut ? text : tr("Section: nothing is in the way"), m_drawing.theme().accent());
}

// The reason of a refusal, or to what a drag snaps.
void SceneView::paint_at_pointer(QPainter& painter) const {
  const auto& ghost = m_document.ghost();
  const auto& pointer = m_toolbox.last_pointer();
  if (!pointer || pointer->window != m_kind || pointer->kind == PointerEvent::Kind::Leave) return;
  const Theme& theme = m_drawing.theme();
  const bool refused = ghost && !ghost->text.empty() &&
                       (ghost->hangs_back || (!ghost->ok && !m_document.is_dragging()));
  const std::string note = refused ? ghost->text : m_toolbox.overlay(view()).note;
  if (!note.empty())
    paint_note(painter, QString::fromStdString(note), pointer->px,
               refused ? theme.refused() : theme.accent());
}

// The note stands beside the pointer, as far as there is room.
void SceneView::paint_note(QPainter& painter, const QString& text, const Vec2& px,
                           const QColor& frame) const {
  constexpr int kWidest = 320, kAside = 18, kPad = 6;
  constexpr int kFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
  const QRect room(0, 0, std::min(kWidest, width() - 4 * kPad), height());
  QRect box = painter.fontMetrics().boundingRect(room, kFlags, text);
  const int x = static_cast<int>(px.x()), y = static_cast<int>(px.y());
  box.moveTopLeft({std::clamp(x + kAside, 2 * kPad, std::max(width() - box.width() - 2 * kPad, 0)),
                   std::min(y + kAside, std::max(height() - box.height() - 2 * kPad, 0))});
  const Theme& theme = m_drawing.theme();
  QColor under = theme.window();
  under.setAlpha(230);
  painter.setPen(QPen(frame, 1));
  painter.setBrush(under);
  painter.drawRoundedRect(QRectF(box).adjusted(-kPad, -kPad, kPad, kPad), 3, 3);
  painter.setPen(theme.text());
  painter.drawText(box, kFlags, text);
}

}  // namespace trivet::edit
