#include "apps/edit/window/main_window.h"

#include <QApplication>
#include <QStatusBar>
#include <QVBoxLayout>

#include "apps/edit/tools/constraint_camera.h"
#include "apps/edit/window/preferences_dialog.h"

namespace trivet::edit {
namespace {

constexpr int kNoteMs = 12000;  // for which a note stays in the status bar

QString aim_note(const Selection& selection) {
  switch (selection.contact ? selection.contact->part : ActiveContact::Part::Area) {
    case ActiveContact::Part::Edge:
      return MainWindow::tr("along the held edge of its contact with %1");
    case ActiveContact::Part::Point:
      return MainWindow::tr("along the normal at the held point of its contact with %1");
    case ActiveContact::Part::Area:
      break;
  }
  return MainWindow::tr("along the normal of its contact with %1");
}

}  // namespace

MainWindow::MainWindow(Document& document, const EditorDetection& detection)
    : m_document(document),
      m_toolbox(document),
      m_drawing(document, m_toolbox),
      m_detection(detection) {
  setObjectName("trivet-edit");
  setAcceptDrops(true);
  QApplication::instance()->installEventFilter(this);
  make_views();
  make_zlist_dock();
  make_asset_dock();
  make_arrange_dock();
  make_actions();
  make_status_bar();
  connect_document();
  restore_layout();
  show_start_page();
  take_tool(ToolKind::Select);
  follow_scene();
}

MainWindow::~MainWindow() {
  m_toolbox.changed = nullptr;
  m_document.disconnect(this);
  m_zlist_dock->disconnect(this);
  m_asset_dock->disconnect(this);
  m_arrange_dock->disconnect(this);
  delete takeCentralWidget();  // delete before the members used by the views
}

void MainWindow::make_views() {
  const auto make = [this](WindowKind kind) {
    auto* const view = new SceneView(kind, m_document, m_toolbox, m_drawing, m_painter);
    connect(view, &SceneView::pointed, this, &MainWindow::update_status);
    connect(view, &SceneView::context_menu_wanted, this, &MainWindow::show_context_menu);
    return view;
  };
  m_control = new ControlWindow(m_document, m_toolbox);
  m_perspective = make(WindowKind::Perspective);
  m_three = make(WindowKind::ThreeView);
  m_constraint = make(WindowKind::Constraint);
  m_constraint->set_camera(ViewCamera::orthographic(-Vec3::UnitZ(), Vec3::UnitY()));
  connect(m_constraint, &SceneView::camera_moved, this, [this] { m_constraint_is_free = true; });
  m_frames = {
      new ViewFrame(tr("Control"), m_control), new ViewFrame(tr("Perspective"), m_perspective),
      new ViewFrame(tr("Three-view"), m_three), new ViewFrame(tr("Constraint"), m_constraint)};
  for (ViewFrame* const frame : m_frames)
    connect(frame, &ViewFrame::maximise_wanted, this, [this, frame] { toggle_maximised(frame); });
  arrange_views();
  connect(m_control, &ControlWindow::demo_wanted, this, &MainWindow::open_demo);
  connect(m_control, &ControlWindow::file_wanted, this, &MainWindow::open_file);
  connect(&m_control->outliner(), &Outliner::put_wanted, this,
          [this] { take_tool(ToolKind::Put); });
  connect(&m_control->outliner(), &Outliner::context_menu_wanted, this,
          &MainWindow::show_context_menu);
  connect(&m_control->outliner(), &Outliner::frame_wanted, this,
          [this] { action("frame")->trigger(); });
  connect(&m_control->operations(), &OperationPanel::tool_wanted, this, &MainWindow::take_tool);
}

void MainWindow::arrange_views() {
  m_left = new QSplitter(Qt::Vertical);
  m_left->addWidget(m_frames[0]), m_left->addWidget(m_frames[2]);
  m_right = new QSplitter(Qt::Vertical);
  m_right->addWidget(m_frames[1]), m_right->addWidget(m_frames[3]);
  m_columns = new QSplitter(Qt::Horizontal);
  m_columns->addWidget(m_left), m_columns->addWidget(m_right);
  for (QSplitter* const splitter : {m_left, m_right, m_columns}) {
    splitter->setHandleWidth(3);
    splitter->setChildrenCollapsible(false);
  }
  m_workspace = new QWidget;
  auto* const column = new QVBoxLayout(m_workspace);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_columns);
  m_message_bar = new MessageBar(m_workspace);
  connect(m_message_bar, &MessageBar::dismissed, &m_drawing, &SceneDrawing::put_out_lights);
  m_start_page = new StartPage;
  m_pages = new QStackedWidget;
  m_pages->addWidget(m_start_page), m_pages->addWidget(m_workspace);
  setCentralWidget(m_pages);
}

// Off by default: nothing is computed for it then.
void MainWindow::make_zlist_dock() {
  m_zlists = new ZListPanel(m_document);
  m_zlist_dock = new QDockWidget(tr("z-lists of the motion"), this);
  m_zlist_dock->setObjectName("zlist_dock");
  m_zlist_dock->setWidget(m_zlists);
  addDockWidget(Qt::BottomDockWidgetArea, m_zlist_dock);
  m_zlist_dock->hide();
  connect(m_zlist_dock, &QDockWidget::visibilityChanged, this, [this] {
    const bool on = !m_zlist_dock->isHidden();
    if (on != m_document.watches_zlists()) m_document.watch_zlists(on);
    action("zlists")->setChecked(on);
    place_message_bar();
  });
}

void MainWindow::connect_document() {
  m_toolbox.changed = [this] {
    for (SceneView* const view : {m_perspective, m_three, m_constraint}) view->follow_tool();
    show_tool();
    update_status();
  };
  connect(&m_document, &Document::snapshot_changed, this, &MainWindow::follow_scene);
  connect(&m_document, &Document::selection_changed, this, &MainWindow::follow_scene);
  connect(&m_document, &Document::history_changed, this, &MainWindow::update_title);
  connect(&m_document, &Document::file_changed, this, &MainWindow::update_title);
  connect(&m_document, &Document::ghost_changed, this, &MainWindow::update_status);
  connect(&m_document, &Document::detection_changed, this, &MainWindow::show_detection);
  connect(&m_document, &Document::snapshot_changed, this, &MainWindow::show_verdict);
  connect(&m_document, &Document::verdict_changed, this, &MainWindow::show_verdict);
  connect(&m_document, &Document::detection_noted, this, &MainWindow::show_note);
  show_detection();
  connect(&m_document, &Document::busy_changed, this, &MainWindow::follow_busy);
  connect(&m_document, &Document::progressed, this,
          [this](const QString& what, int done, int total) {
            m_busy->setText(what);
            m_progress->setRange(0, total);
            m_progress->setValue(done);
          });
  connect(&m_document, &Document::message, this, [this](const Message& message) {
    m_message_bar->show_message(message);
    place_message_bar();
  });
  connect(&m_document, &Document::finished, this, [this](quint64 job, bool ok) {
    const auto waiting = m_waiting.extract(job);
    if (!waiting.empty()) waiting.mapped()(ok);
  });
}

// --- display -----------------------------------------------------------------------------------

void MainWindow::show_note(const QString& note) { statusBar()->showMessage(note, kNoteMs); }

void MainWindow::show_start_page() {
  m_start_page->show_choices(recent_files(), m_document.recoverable());
  m_control->show_files(recent_files());
  m_pages->setCurrentWidget(m_start_page);
}

void MainWindow::show_workspace() {
  if (m_pages->currentWidget() == m_workspace) return;
  m_pages->setCurrentWidget(m_workspace);
  m_perspective->setFocus();
}

void MainWindow::ask_preferences() {
  ToolOptions& options = m_toolbox.options();
  auto* const dialog = new PreferencesDialog(
      m_document, m_detection, {options.snap.grid_step, options.angle_step_deg}, this);
  connect(dialog, &PreferencesDialog::steps_chosen, this, [this](const SnapSteps& steps) {
    m_toolbox.options().snap.grid_step = steps.grid;
    m_toolbox.options().angle_step_deg = steps.angle_deg;
    save_snapping();
    m_control->operations().show_tool(m_toolbox.current());
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
  if (kind != ToolKind::Select) m_control->show_operations();
}

/// Tools can also be selected by keys of the toolbox.
void MainWindow::show_tool() {
  const ToolKind kind = m_toolbox.current();
  static constexpr const char* kActions[] = {"select", "put",    "push",  "turn", "pick up",
                                             "move",   "rotate", "paint", "drape"};
  QAction* const shown = action(kActions[static_cast<int>(kind)]);
  if (shown->isChecked() && kind == m_shown_tool) return;
  m_shown_tool = kind;
  shown->setChecked(true);
  m_control->operations().show_tool(kind);
}

void MainWindow::follow_scene() {
  const auto snapshot = m_document.snapshot();
  const bool is_empty = snapshot->objects.empty();
  if (!is_empty || m_document.is_modified()) show_workspace();
  // Frames a newly opened scene, or the first object of an empty one.
  const Aabb box = snapshot->box();
  if (box.empty() && !m_is_empty) reset_cameras();
  if ((m_framed_title != m_document.title() || m_is_empty) && !box.empty() && !snapshot->drag) {
    m_framed_title = m_document.title();
    for (SceneView* const view : {m_perspective, m_three, m_constraint}) view->frame(box);
  }
  m_is_empty = box.empty();
  aim_constraint_window();
  update_actions();
  update_status();
}

void MainWindow::aim_constraint_window() {
  const auto snapshot = m_document.snapshot();
  if (snapshot->drag) return;
  const auto active = m_document.selection().active();
  if (active != m_aimed_at) m_constraint_is_free = false;
  m_aimed_at = active;
  if (m_constraint_is_free) return;
  const View view = constraint_view(*snapshot, m_document.selection(), std::nullopt,
                                    m_constraint->width(), m_constraint->height());
  m_constraint->set_camera(ViewCamera::of(view));
  const ObjectContact* const entry = active_object_contact(m_document.selection(), *snapshot);
  const ObjectSnapshot* const with =
      entry && entry->with.is_object() ? snapshot->find(entry->with.object()) : nullptr;
  m_frames[3]->set_note(
      !entry ? tr("from above")
             : aim_note(m_document.selection())
                   .arg(with ? QString::fromStdString((*with)->name) : tr("the floor")));
}

SceneView& MainWindow::view(WindowKind kind) {
  return kind == WindowKind::Perspective  ? *m_perspective
         : kind == WindowKind::Constraint ? *m_constraint
                                          : *m_three;
}

SceneView* MainWindow::active_view() const {
  for (SceneView* const view : {m_three, m_constraint, m_perspective})
    if (view->underMouse()) return view;
  for (SceneView* const view : {m_three, m_constraint})
    if (view->hasFocus()) return view;
  return m_perspective;
}

}  // namespace trivet::edit
