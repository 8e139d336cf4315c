// Main window of the editor: four views, menus, message bar, status. Start here for display logic;
// menus.cpp has the actions, files.cpp opening and saving.
#pragma once

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QProgressBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <functional>
#include <map>

#include "apps/edit/window/asset_browser.h"
#include "apps/edit/window/bookmarks.h"
#include "apps/edit/window/control_window.h"
#include "apps/edit/window/detection_choice.h"
#include "apps/edit/window/help.h"
#include "apps/edit/window/icons.h"
#include "apps/edit/window/message_bar.h"
#include "apps/edit/window/picture_dialog.h"
#include "apps/edit/window/scene_view.h"
#include "apps/edit/window/start_page.h"
#include "apps/edit/window/view_frame.h"
#include "apps/edit/window/zlist_panel.h"

namespace trivet::edit {

class ArrangePanel;
class AssetDrag;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// @param detection  what the document was made with.
  explicit MainWindow(Document& document, const EditorDetection& detection = {});
  ~MainWindow() override;

  // For the command line and tests.
  void open_file(const QString& file);  // scene, layout, or a model to import
  void open_demo(const QString& name);
  void show_note(const QString& note);  // in the status bar, for a while
  SceneView& view(WindowKind kind);
  Toolbox& toolbox() { return m_toolbox; }
  MessageBar& message_bar() { return *m_message_bar; }
  ControlWindow& control() { return *m_control; }
  const SceneDrawing& drawing() const { return m_drawing; }
  AssetBrowser& assets() { return *m_assets; }
  QAction* action(const QString& name) const { return m_actions.at(name); }
  void set_dark(bool dark);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  using ViewFrames = std::array<ViewFrame*, 4>;  // control, perspective, three-view, constraint

  // main_window.cpp
  void make_views();
  void arrange_views();
  void make_zlist_dock();
  // arrange_dock.cpp
  void make_arrange_dock();
  void make_arrange_action();
  void connect_document();
  void show_workspace();
  void show_start_page();
  void ask_preferences();
  void take_tool(ToolKind kind);
  void show_tool();
  void follow_scene();
  void aim_constraint_window();
  SceneView* active_view() const;

  // feedback.cpp
  void make_status_bar();
  void update_title();
  void follow_busy();
  void show_busy();
  void update_status();
  void show_detection();
  void show_verdict();
  void update_actions();

  // window_events.cpp
  bool eventFilter(QObject* watched, QEvent* event) override;

  // arrangement.cpp
  void toggle_maximised(ViewFrame* frame);
  void place_message_bar();
  void aim_three_view(const QString& name);
  void look_along(const Vec3& direction);
  void reset_cameras();
  void reset_layout();
  void restore_layout();
  void save_layout() const;

  // snapping_actions.cpp
  void make_snap_actions();
  void dress_snap_button(QToolBar& bar);
  void restore_snapping();
  void save_snapping() const;

  // views.cpp
  SceneView* view_of(ViewFrame* frame) const;
  void make_section_actions();
  void toggle_section(SceneView& view);
  void make_bookmark_actions();
  void follow_bookmarks();
  void name_bookmarks();
  void store_bookmark(int number);
  void show_bookmark(int number);
  void reset_cameras_if_empty();

  // menus.cpp
  QAction* add_action(const QString& name, const QString& text, const QKeySequence& keys,
                      std::function<void()> done, const QString& tip = {});
  void make_actions();
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
  void dress_actions();
  void show_context_menu(const QPoint& global);
  std::vector<ShortcutRow> shortcut_rows() const;

  // view_actions.cpp
  void make_view_actions();
  void make_three_view_actions();
  void make_drawing_actions();
  void make_direction_actions();

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

  // assets.cpp
  void make_asset_dock();
  void take_asset(const Asset& asset);
  SceneView* view_at(const QPoint& at) const;
  void hover_assets(const QList<QUrl>& urls, const QPoint& at);
  void end_asset_drag();
  void drop_assets(const QList<QUrl>& urls, const QPoint& at);
  void drop_asset(const Asset& asset, SceneView& view, const QPoint& at);

  // files.cpp
  bool may_lose_work(std::function<void()> then);
  void new_scene();
  void ask_open();
  void save(std::function<void()> then);
  void save_as(std::function<void()> then);
  void ask_export();
  void ask_import();
  void import_files(const QStringList& files);
  void import_next();
  void show_not_imported();
  void ask_picture();
  void remember_file(const QString& file);
  QString file_to_save(const QString& extension) const;
  QStringList recent_files() const;
  void fill_recent_menu();
  void when_finished(Document::Job job, std::function<void(bool)> then);
  void say(Message::Kind kind, const QString& text);

  Document& m_document;
  Toolbox m_toolbox;
  SceneDrawing m_drawing;
  Painter m_painter;
  std::map<QString, QAction*> m_actions;
  std::map<QAction*, Icon> m_icons;
  QMenu* m_recent_menu = nullptr;
  QMenu* m_context_menu = nullptr;
  QMenu* m_colours = nullptr;
  QMenu *m_bookmark_menu = nullptr, *m_snap_menu = nullptr;
  std::map<const SceneView*, QToolButton*> m_section_buttons;
  Bookmarks m_bookmarks;
  QString m_bookmarks_of;      // file
  bool m_is_replaced = false;  // the scene is about to be another one
  size_t m_num_done = 0;       // steps
  QStackedWidget* m_pages = nullptr;
  StartPage* m_start_page = nullptr;
  QWidget* m_workspace = nullptr;
  QSplitter *m_columns = nullptr, *m_left = nullptr, *m_right = nullptr;
  ControlWindow* m_control = nullptr;
  SceneView *m_perspective = nullptr, *m_three = nullptr, *m_constraint = nullptr;
  ViewFrames m_frames = {};
  ViewFrame* m_maximised = nullptr;
  MessageBar* m_message_bar = nullptr;
  QDockWidget* m_zlist_dock = nullptr;
  ZListPanel* m_zlists = nullptr;
  QDockWidget* m_asset_dock = nullptr;
  AssetBrowser* m_assets = nullptr;
  AssetDrag* m_asset_drag = nullptr;
  QString m_dragged_asset;  // file
  QDockWidget* m_arrange_dock = nullptr;
  ArrangePanel* m_arrange_panel = nullptr;
  EditorDetection m_detection;
  QLabel *m_hand = nullptr, *m_hint = nullptr, *m_count = nullptr, *m_busy = nullptr,
         *m_answering = nullptr;
  QLabel* m_stands = nullptr;
  QProgressBar* m_progress = nullptr;
  QToolButton* m_cancel = nullptr;
  QTimer m_busy_for_long;
  std::map<Document::Job, std::function<void(bool)>> m_waiting;
  std::deque<ImportModel> m_imports;
  size_t m_num_imports = 0;
  QStringList m_not_imported;
  std::unique_ptr<PictureJob> m_picture;
  std::optional<std::string> m_framed_title;
  std::optional<ObjectId> m_aimed_at;
  ToolKind m_shown_tool = ToolKind::Select;
  QString m_three_shows;
  bool m_was_busy = false, m_is_empty = true, m_may_close = false, m_constraint_is_free = false;
};

}  // namespace trivet::edit
