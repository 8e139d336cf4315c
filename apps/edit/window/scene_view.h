// Widget for a view of the scene: shows the painter's pictures, moves its camera, and passes other
// mouse events to the tools.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>

#include "apps/edit/tools/section.h"
#include "apps/edit/tools/toolbox.h"
#include "apps/edit/window/painter.h"
#include "apps/edit/window/scene_drawing.h"
#include "apps/edit/window/view_camera.h"

namespace trivet::edit {

class SceneView : public QWidget {
  Q_OBJECT

 public:
  SceneView(WindowKind kind, Document& document, Toolbox& toolbox, SceneDrawing& drawing,
            Painter& painter, QWidget* parent = nullptr);

  WindowKind kind() const { return m_kind; }
  const ViewCamera& camera() const { return m_camera; }
  void set_camera(const ViewCamera& camera);
  View view() const;
  const Section& section() const { return m_section; }
  void set_section(const Section& section);
  void frame(const Aabb& box);
  /// Box to frame: of the selection, else of the scene.
  Aabb selected_box() const;
  void redraw();
  /// Redraws the tool's overlay.
  void follow_tool();
  /// True if the visible picture shows the document in full quality. For tests.
  bool is_up_to_date() const { return shows_latest() && !m_shown_is_draft; }
  /// The same, but a draft suffices.
  bool shows_latest() const { return m_shown == m_wanted; }
  double last_picture_ms() const { return m_picture_ms; }

 Q_SIGNALS:
  void pointed();       // the tools got an event
  void camera_moved();  // by the user
  void context_menu_wanted(const QPoint& global);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  enum class CameraDrag { None, Orbit, Pan, Zoom };
  CameraDrag camera_drag_of(const QMouseEvent& event) const;
  void move_camera(const QPointF& moved_px);
  bool camera_moves() const;
  bool is_in_motion() const;
  void request();
  int& coarseness();
  void take(int view, quint64 number, const QImage& image, double milliseconds, bool whole);
  bool turn_in_hand(const QWheelEvent& event);
  bool send(PointerEvent::Kind kind, const QMouseEvent& event);
  void paint_label(QPainter& painter, const QRectF& box, int flags, const QString& text,
                   const QColor& colour) const;
  void paint_axes(QPainter& painter) const;
  void paint_scale(QPainter& painter) const;
  void paint_rubber_band(QPainter& painter) const;
  void paint_at_pointer(QPainter& painter) const;
  void paint_note(QPainter& painter, const QString& text, const Vec2& px,
                  const QColor& frame) const;
  void paint_section(QPainter& painter) const;
  void update_cursor();

  WindowKind m_kind;
  Document& m_document;
  Toolbox& m_toolbox;
  SceneDrawing& m_drawing;
  Painter& m_painter;
  ViewCamera m_camera;
  Section m_section;
  std::optional<double> m_cut;  // depth of the section, for this scene and camera
  QImage m_image;
  QString m_failure;
  quint64 m_wanted = 0, m_requested = 0, m_shown = 0;  // picture numbers
  bool m_waiting = false, m_requested_draft = false, m_shown_is_draft = true;
  // Screen pixels per pixel of drafts: while objects move, while the camera moves.
  int m_coarseness = 1, m_camera_coarseness = 1;
  double m_picture_ms = 0;
  CameraDrag m_camera_drag = CameraDrag::None;
  QPointF m_last_position, m_pressed_at;
  std::vector<double> m_tool_lines;  // as drawn last
  QElapsedTimer m_camera_moved;
  QTimer m_calm;  // ends drafts
};

}  // namespace trivet::edit
