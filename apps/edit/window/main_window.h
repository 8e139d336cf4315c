// Main window of the editor: joins the workspace, docks, menus and status, which own their state.
// Start here for display logic; menus.cpp has the actions, files.cpp opening and saving.
#pragma once

#include <QMainWindow>
#include <QMenu>
#include <QStackedWidget>
#include <functional>
#include <memory>

#include "apps/edit/window/action_set.h"
#include "apps/edit/window/arrange_dock.h"
#include "apps/edit/window/asset_dock.h"
#include "apps/edit/window/bookmark_menu.h"
#include "apps/edit/window/detection_choice.h"
#include "apps/edit/window/import_queue.h"
#include "apps/edit/window/picture_dialog.h"
#include "apps/edit/window/snap_menu.h"
#include "apps/edit/window/start_page.h"
#include "apps/edit/window/status_line.h"
#include "apps/edit/window/workspace.h"
#include "apps/edit/window/zlist_dock.h"

namespace trivet::edit {

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// @param detection  what the document was made with.
  explicit MainWindow(Document& document, const EditorDetection& detection = {});
  ~MainWindow() override;

  // For the command line and tests.
  void open_file(const QString& file);  // scene, layout, or a model to import
  void open_demo(const QString& name);
  void show_note(const QString& note) { m_status->show_note(note); }
  SceneView& view(WindowKind kind) { return m_workspace->view(kind); }
  Toolbox& toolbox() { return m_toolbox; }
  MessageBar& message_bar() { return m_workspace->message_bar(); }
  ControlWindow& control() { return m_workspace->control(); }
  const SceneDrawing& drawing() const { return m_drawing; }
  AssetBrowser& assets() { return m_asset_dock->browser(); }
  QAction* action(const QString& name) const { return m_actions.at(name); }
  void set_dark(bool dark);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  // main_window.cpp
  void connect_workspace();
  void make_docks();
  void add_dock(QDockWidget& dock, const char* action_name);
  void connect_document();
  void connect_toolbox();
  void show_workspace();
  void show_start_page();
  void ask_preferences();
  void take_tool(ToolKind kind);
  void show_tool();
  void follow_scene();
  void update_title();
  void update_actions();
  void follow_busy();
  void restore_layout();
  void save_layout() const;

  // window_events.cpp
  bool eventFilter(QObject* watched, QEvent* event) override;

  // menus.cpp
  QAction* add_action(const QString& name, const QString& text, const QKeySequence& keys,
                      std::function<void()> done, const QString& tip = {}) {
    return m_actions.add(name, text, keys, std::move(done), tip);
  }
  void make_actions();
  void make_help_actions();
  void make_file_actions();
  void make_edit_actions();
  void make_tool_actions();
  void make_hand_actions();
  void connect_start_page();
  QMenu* add_menu(const QString& title, std::initializer_list<const char*> names);
  void make_file_menu();
  void make_view_menu();
  void make_context_menu();
  void make_menus();
  void make_tool_bar();

  // view_actions.cpp
  void make_view_actions();
  void make_three_view_actions();
  void make_drawing_actions();
  void make_direction_actions();
  QAction* add_switch(const char* name, const QString& text, const QKeySequence& keys,
                      std::function<void(bool)> change, const QString& tip = {});

  // edits.cpp: menu actions on the selection
  void duplicate();
  void perform_on_selection(const QString& name,
                            const std::function<Operation(const std::string&)>& make);
  void lock_selected(bool locked);
  void fix_selected(bool fixed);
  void group_selected(bool together);
  void select_all();

  // many_edits.cpp
  void make_many_actions();
  void make_look_actions();
  std::vector<std::string> selected_names() const;
  void perform_many(const QString& name, ManyObjects many);
  void make_array();
  void scatter(bool put_all);
  void align_selected();
  void replace_selected();
  /// Changes the looks of the selected objects. @param name  of the step.
  void change_looks(const QString& name, const std::function<void(Look&)>& change);
  void reset_looks(const QString& name, bool Look::*field);

  // collect.cpp
  void make_collection_actions();
  void collect_selected();

  // files.cpp
  bool may_lose_work(std::function<void()> then);
  void new_scene();
  void ask_open();
  void save(std::function<void()> then);
  void save_as(std::function<void()> then);
  void ask_export();
  void ask_import();
  void import_files(const QStringList& files);
  void connect_imports();
  void ask_picture();
  void remember_file(const QString& file);
  QString file_to_save(const QString& extension) const;
  QStringList recent_files() const;
  void fill_recent_menu();
  void when_finished(Document::Job job, std::function<void(bool)> then) {
    m_ends.when_finished(job, std::move(then));
  }
  void say(Message::Kind kind, const QString& text);

  Document& m_document;
  Toolbox m_toolbox;
  SceneDrawing m_drawing;
  JobEnds m_ends;
  ImportQueue m_imports;
  ActionSet m_actions;
  Workspace* m_workspace;
  StartPage* m_start_page;
  QStackedWidget* m_pages;  // these two
  std::unique_ptr<StatusLine> m_status;
  ZListDock* m_zlist_dock;
  AssetDock* m_asset_dock;
  ArrangeDock* m_arrange_dock;
  QMenu *m_recent_menu = nullptr, *m_context_menu = nullptr, *m_colours = nullptr;
  BookmarkMenu* m_bookmark_menu = nullptr;
  SnapMenu* m_snap_menu = nullptr;
  std::unique_ptr<PictureJob> m_picture;
  EditorDetection m_detection;
  ToolKind m_shown_tool = ToolKind::Select;
  bool m_was_busy = false, m_may_close = false;
};

}  // namespace trivet::edit
