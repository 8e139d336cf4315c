// The four windows of a scene, the cameras of its views, and the message bar over them.
#pragma once

#include <QSplitter>
#include <QToolButton>
#include <QWidget>
#include <array>
#include <map>

#include "apps/edit/window/control_window.h"
#include "apps/edit/window/message_bar.h"
#include "apps/edit/window/scene_view.h"
#include "apps/edit/window/view_frame.h"

namespace trivet::edit {

class Workspace : public QWidget {
  Q_OBJECT

 public:
  Workspace(Document& document, Toolbox& toolbox, SceneDrawing& drawing);
  ~Workspace() override;

  SceneView& view(WindowKind kind) const;
  /// The view under the mouse, else with the focus, else the perspective.
  SceneView& active_view() const;
  /// @param at  pixel of the window. @return null: there is no view.
  SceneView* view_at(const QPoint& at) const;
  ControlWindow& control() const { return *m_control; }
  MessageBar& message_bar() const { return *m_message_bar; }
  /// Renderer in use; empty until the first picture.
  QString device() const { return m_painter.device(); }
  void set_theme(const Theme& theme);
  void show_message(const Message& message);
  void place_message_bar();

  /// Shows the scene as it is now: cameras of an empty scene, of a new one, along the contact.
  void follow_scene();
  /// Redraws the overlays of the tool.
  void follow_tool();
  /// The next scene is framed, even if it has the title of this one.
  void frame_next_scene() { m_framed_title.reset(); }

  // workspace_cameras.cpp
  /// @param name  "top", "side" or "front".
  void aim_three_view(const QString& name);
  /// Turns the active view.
  void look_along(const Vec3& direction);
  void show_camera(WindowKind kind, const ViewCamera& camera);
  /// Cameras of an empty scene, as in a new window.
  void reset_cameras();
  /// The constraint window looks along the contact again.
  void follow_contact();

  /// Switches the section of a view on or off.
  void toggle_section(SceneView& view);
  /// Maximises the active view, or restores all.
  void toggle_maximised();
  void add_to_three_view_title(QWidget* widget) { m_frames[2]->add_to_title(widget); }
  void reset_layout();
  /// From and to the settings.
  void restore_layout();
  void save_layout() const;

 Q_SIGNALS:
  void pointed();  // the tools got an event
  void context_menu_wanted(const QPoint& global);
  void three_view_aimed(const QString& name);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  using ViewFrames = std::array<ViewFrame*, 4>;  // control, perspective, three-view, constraint
  using SceneViews = std::array<SceneView*, 3>;
  SceneView* make_view(WindowKind kind);
  void make_frames();
  void arrange();
  void make_section_buttons();
  void maximise(ViewFrame* frame);
  SceneViews views() const { return {m_perspective, m_three, m_constraint}; }
  void aim_constraint_view();

  Document& m_document;
  Toolbox& m_toolbox;
  SceneDrawing& m_drawing;
  Painter m_painter;
  QSplitter *m_columns, *m_left, *m_right;
  ControlWindow* m_control;
  SceneView *m_perspective, *m_three, *m_constraint;
  ViewFrames m_frames;
  ViewFrame* m_maximised = nullptr;
  MessageBar* m_message_bar;
  std::map<const SceneView*, QToolButton*> m_section_buttons;
  std::optional<std::string> m_framed_title;
  std::optional<ObjectId> m_aimed_at;
  QString m_three_shows;
  bool m_is_empty = true, m_constraint_is_free = false;
};

}  // namespace trivet::edit
