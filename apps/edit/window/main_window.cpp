#include "apps/edit/window/main_window.h"

#include <QApplication>
#include <QSettings>

#include "apps/edit/window/preferences_dialog.h"

namespace trivet::edit {

MainWindow::MainWindow(Document& document, const EditorDetection& detection)
    : m_document(document),
      m_toolbox(document),
      m_drawing(document, m_toolbox),
      m_ends(document),
      m_imports(document, m_ends),
      m_actions(*this),
      m_workspace(new Workspace(document, m_toolbox, m_drawing)),
      m_start_page(new StartPage),
      m_pages(new QStackedWidget),
      m_status(std::make_unique<StatusLine>(document, m_toolbox, m_drawing, *statusBar())),
      m_zlist_dock(new ZListDock(document, this)),
      m_asset_dock(new AssetDock(document, m_toolbox, m_ends, this)),
      m_arrange_dock(new ArrangeDock(document, this)),
      m_detection(detection) {
  setObjectName("trivet-edit");
  setAcceptDrops(true);
  QApplication::instance()->installEventFilter(this);
  m_pages->addWidget(m_start_page), m_pages->addWidget(m_workspace);
  setCentralWidget(m_pages);
  make_actions();
  make_docks();
  connect_workspace();
  connect_imports();
  connect_document();
  connect_toolbox();
  restore_layout();
  show_start_page();
  take_tool(ToolKind::Select);
  follow_scene();
}

MainWindow::~MainWindow() {
  m_toolbox.changed = nullptr;
  m_document.disconnect(this);
  delete takeCentralWidget();  // delete before the members used by the views
}

void MainWindow::connect_workspace() {
  connect(m_workspace, &Workspace::pointed, m_status.get(), &StatusLine::follow_tool);
  const auto show_menu = [this](const QPoint& global) { m_context_menu->popup(global); };
  connect(m_workspace, &Workspace::context_menu_wanted, this, show_menu);
  connect(m_workspace, &Workspace::three_view_aimed, this,
          [this](const QString& name) { action(name)->setChecked(true); });
  connect(&control(), &ControlWindow::demo_wanted, this, &MainWindow::open_demo);
  connect(&control(), &ControlWindow::file_wanted, this, &MainWindow::open_file);
  const Outliner* const outliner = &control().outliner();
  connect(outliner, &Outliner::put_wanted, this, [this] { take_tool(ToolKind::Put); });
  connect(outliner, &Outliner::context_menu_wanted, this, show_menu);
  connect(outliner, &Outliner::frame_wanted, this, [this] { action("frame")->trigger(); });
  connect(&control().operations(), &OperationPanel::tool_wanted, this, &MainWindow::take_tool);
}

void MainWindow::make_docks() {
  add_dock(*m_zlist_dock, "zlists");
  add_dock(*m_asset_dock, "assets");
  add_dock(*m_arrange_dock, "arrange");
  connect(m_asset_dock, &AssetDock::model_chosen, this, &MainWindow::show_workspace);
  connect(m_asset_dock, &AssetDock::in_hand, this, [this] { take_tool(ToolKind::Put); });
  connect(&assets(), &AssetBrowser::refused, this,
          [this](const QString& why) { say(Message::Kind::Error, why); });
}

/// Hidden at first. @param action_name  of the action that is checked while it is shown.
void MainWindow::add_dock(QDockWidget& dock, const char* action_name) {
  addDockWidget(Qt::BottomDockWidgetArea, &dock);
  dock.hide();
  QAction* const shown = action(action_name);
  connect(&dock, &QDockWidget::visibilityChanged, shown,
          [&dock, shown] { shown->setChecked(!dock.isHidden()); });
}

void MainWindow::connect_toolbox() {
  m_toolbox.changed = [this] {
    m_workspace->follow_tool();
    show_tool();
    m_status->follow_tool();
  };
}

void MainWindow::connect_document() {
  connect(&m_document, &Document::snapshot_changed, this, &MainWindow::follow_scene);
  connect(&m_document, &Document::selection_changed, this, &MainWindow::follow_scene);
  connect(&m_document, &Document::history_changed, this, &MainWindow::update_title);
  connect(&m_document, &Document::file_changed, this, &MainWindow::update_title);
  connect(&m_document, &Document::busy_changed, this, &MainWindow::follow_busy);
  connect(&m_document, &Document::message, m_workspace, &Workspace::show_message);
  connect(m_status.get(), &StatusLine::cancel_wanted, this, [this] {
    m_document.cancel();
    if (m_picture) m_picture->cancel();
  });
}

// --- display -----------------------------------------------------------------------------------

void MainWindow::show_start_page() {
  m_start_page->show_choices(recent_files(), m_document.recoverable());
  control().show_files(recent_files());
  m_pages->setCurrentWidget(m_start_page);
}

void MainWindow::show_workspace() {
  if (m_pages->currentWidget() == m_workspace) return;
  m_pages->setCurrentWidget(m_workspace);
  view(WindowKind::Perspective).setFocus();
}

void MainWindow::ask_preferences() {
  auto* const dialog = new PreferencesDialog(m_document, m_detection, m_snap_menu->steps(), this);
  connect(dialog, &PreferencesDialog::steps_chosen, this, [this](const SnapSteps& steps) {
    m_snap_menu->set_steps(steps);
    control().operations().show_tool(m_toolbox.current());
  });
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PreferencesDialog::detection_chosen, this,
          [this](const EditorDetection& choice) {
            if (choice == m_detection) return;
            m_detection = choice;
            save_detection(choice);
            m_document.choose_detection(backend_options(choice));
          });
  dialog->show();
}

void MainWindow::take_tool(ToolKind kind) {
  m_toolbox.take(kind);
  show_tool();
  if (kind != ToolKind::Select) control().show_operations();
}

/// Tools can also be selected by keys of the toolbox.
void MainWindow::show_tool() {
  const ToolKind kind = m_toolbox.current();
  static constexpr const char* kActions[] = {"select", "put",    "push",  "turn", "pick up",
                                             "move",   "rotate", "paint", "drape"};
  static_assert(std::size(kActions) == static_cast<size_t>(ToolKind::Drape) + 1);
  QAction* const shown = action(kActions[static_cast<int>(kind)]);
  if (shown->isChecked() && kind == m_shown_tool) return;
  m_shown_tool = kind;
  shown->setChecked(true);
  control().operations().show_tool(kind);
}

void MainWindow::follow_scene() {
  if (!m_document.snapshot()->objects.empty() || m_document.is_modified()) show_workspace();
  m_workspace->follow_scene();
  update_actions();
  m_status->follow_tool();
}

void MainWindow::update_title() {
  const QString title = QString::fromStdString(m_document.title());
  setWindowTitle((title == "Untitled" ? tr("Untitled") : title) + "[*] – Trivet");
  setWindowModified(m_document.is_modified());
  update_actions();
}

void MainWindow::follow_busy() {
  // Dismisses messages about earlier operations.
  if (m_document.is_busy() && !m_was_busy) message_bar().dismiss();
  m_was_busy = m_document.is_busy();
  update_actions();
}

void MainWindow::update_actions() {
  const bool idle = !m_document.is_busy();
  const bool selected = !m_document.selection().objects.empty();
  action("undo")->setEnabled(idle && m_document.can_undo());
  action("redo")->setEnabled(idle && m_document.can_redo());
  for (const char* const name :
       {"duplicate", "delete", "lock", "unlock", "fix", "unfix", "group", "ungroup", "rename",
        "array", "scatter", "align", "replace", "hide", "not selectable", "collect", "uncollect"})
    action(name)->setEnabled(idle && selected);
  action("put all")->setEnabled(idle);
  m_colours->setEnabled(selected);
  for (const char* const name : {"save", "save as", "export", "picture"})
    action(name)->setEnabled(idle);
}

// --- settings ------------------------------------------------------------------------------------

void MainWindow::restore_layout() {
  const QSettings settings;
  if (!restoreGeometry(settings.value("window/geometry").toByteArray())) resize(1280, 720);
  m_workspace->restore_layout();
  DrawingOptions options;
  options.shadows = settings.value("view/shadows", options.shadows).toBool();
  options.contacts = settings.value("view/contacts", options.contacts).toBool();
  options.watch_settling = settings.value("view/watch_settling", options.watch_settling).toBool();
  m_drawing.set_options(options);
  action("shadows")->setChecked(options.shadows);
  action("contacts")->setChecked(options.contacts);
  action("watch settling")->setChecked(options.watch_settling);
  m_zlist_dock->setVisible(settings.value("view/zlists", false).toBool());
  m_asset_dock->setVisible(settings.value("view/assets", false).toBool());
  set_dark(settings.value("view/dark", true).toBool());
}

void MainWindow::save_layout() const {
  QSettings settings;
  settings.setValue("window/geometry", saveGeometry());
  m_workspace->save_layout();
  settings.setValue("view/shadows", m_drawing.options().shadows);
  settings.setValue("view/contacts", m_drawing.options().contacts);
  settings.setValue("view/watch_settling", m_drawing.options().watch_settling);
  settings.setValue("view/zlists", !m_zlist_dock->isHidden());
  settings.setValue("view/assets", !m_asset_dock->isHidden());
  settings.setValue("view/dark", m_drawing.theme().dark);
}

void MainWindow::set_dark(bool dark) {
  Theme theme;
  theme.dark = dark;
  theme.apply(*qApp);
  m_drawing.set_theme(theme);
  m_workspace->set_theme(theme);
  m_zlist_dock->set_theme(theme);
  assets().set_theme(theme);
  m_arrange_dock->set_theme(theme);
  action("dark")->setChecked(dark);
  m_actions.draw_icons(theme.text());
}

}  // namespace trivet::edit
