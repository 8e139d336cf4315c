// A model that is dragged from the browser over the views.
#pragma once

#include <QPoint>

#include "apps/edit/tools/toolbox.h"
#include "apps/edit/window/scene_view.h"

namespace trivet::edit {

/// It is imported on trial, its ghost follows the mouse, and a drop puts it as one step.
class AssetDrag : public QObject {
 public:
  AssetDrag(Document& document, Toolbox& toolbox, QObject* parent);

  /// Imports it, unless it is on trial already.
  void begin(const ImportModel& model);
  /// Shows its ghost under the mouse. @param at  pixel of the view.
  void hover(SceneView& view, const QPoint& at);
  /// Takes the trial back.
  void leave();
  /// Puts it as the ghost shows, or later. @return false: there is no ghost at rest; the trial is
  /// taken back.
  bool drop();

 private:
  void follow(Document::Job job, bool ok);
  void point();
  void take_back();
  void put_late();

  Document& m_document;
  Toolbox& m_toolbox;
  ImportModel m_model;
  Document::Job m_job = 0;
  SceneView* m_view = nullptr;  // under the mouse
  QPoint m_at;
  ToolKind m_tool_before = ToolKind::Select;
  bool m_is_on = false;     // between begin() and the end
  bool m_is_there = false;  // it is imported
  bool m_is_dropped = false;
};

}  // namespace trivet::edit
