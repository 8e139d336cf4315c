// Views of the main window: sections, bookmarks, cameras of an empty scene.
#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QStatusBar>
#include <QToolButton>

#include "apps/edit/window/main_window.h"

namespace trivet::edit {
namespace {

constexpr int kStoredNoteMs = 4000;

QString bookmark_name(int number) { return QString("bookmark %1").arg(number); }
QString store_name(int number) { return QString("store bookmark %1").arg(number); }

}  // namespace

SceneView* MainWindow::view_of(ViewFrame* frame) const {
  return qobject_cast<SceneView*>(frame->content());
}

// --- sections ------------------------------------------------------------------------------------

void MainWindow::make_section_actions() {
  add_action(
      "section", tr("&Section: cut away what is in front"), tr("X"),
      [this] { toggle_section(*active_view()); },
      tr("Section: the window under the mouse cuts away what stands in front of the active object; "
         "Control and the wheel move the plane"));
  for (ViewFrame* const frame : m_frames) {
    SceneView* const view = view_of(frame);
    if (!view) continue;
    auto* const button = new QToolButton;
    button->setObjectName("section");
    button->setText(tr("Section"));
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    button->setToolTip(view == m_constraint
                           ? tr("Cut away what hides the active object (X); Control and the wheel "
                                "move the plane")
                           : tr("Cut away what stands in front of the active object (X); Control "
                                "and the wheel move the plane"));
    connect(button, &QToolButton::clicked, this, [this, view] { toggle_section(*view); });
    frame->add_to_title(button);
    m_section_buttons[view] = button;
  }
  // Under a shelf's board the constraint window would show nothing but the board.
  toggle_section(*m_constraint);
}

void MainWindow::toggle_section(SceneView& view) {
  Section section;
  section.on = !view.section().on;
  section.only_if_hidden = &view == m_constraint;
  view.set_section(section);
  m_section_buttons.at(&view)->setChecked(section.on);
}

// --- bookmarks -----------------------------------------------------------------------------------

void MainWindow::make_bookmark_actions() {
  m_bookmark_menu = new QMenu(tr("&Bookmarks"), this);
  m_bookmark_menu->setObjectName("bookmarks");
  for (int number = 1; number <= Bookmarks::kMost; ++number)
    m_bookmark_menu->addAction(add_action(
        bookmark_name(number), tr("View &%1").arg(number),
        QKeySequence(Qt::ALT | (Qt::Key_0 + number)), [this, number] { show_bookmark(number); },
        tr("Show the view stored as %1").arg(number)));
  m_bookmark_menu->addSeparator();
  for (int number = 1; number <= Bookmarks::kMost; ++number)
    m_bookmark_menu->addAction(add_action(
        store_name(number), tr("Store as view %1").arg(number),
        QKeySequence(Qt::CTRL | (Qt::Key_0 + number)), [this, number] { store_bookmark(number); },
        tr("Store the view under the mouse as %1").arg(number)));
  connect(&m_document, &Document::scene_replaced, this, [this] { m_is_replaced = true; });
  connect(&m_document, &Document::history_changed, this, &MainWindow::follow_bookmarks);
  name_bookmarks();
}

// The scene's file was opened, or it was saved under another name.
void MainWindow::follow_bookmarks() {
  const QString file = QString::fromStdString(m_document.file());
  if (m_is_replaced)
    m_bookmarks.load(file), reset_cameras_if_empty();
  else if (!file.isEmpty() && file != m_bookmarks_of)
    m_bookmarks.keep_for(file);
  else if (m_document.history().num_done < m_num_done)
    reset_cameras_if_empty();
  m_is_replaced = false;
  m_bookmarks_of = file;
  m_num_done = m_document.history().num_done;
  name_bookmarks();
}

void MainWindow::reset_cameras_if_empty() {
  if (m_document.snapshot()->box().empty()) reset_cameras();
}

void MainWindow::name_bookmarks() {
  for (int number = 1; number <= Bookmarks::kMost; ++number) {
    const Bookmark* const found = m_bookmarks.find(number);
    QAction* const shown = action(bookmark_name(number));
    shown->setEnabled(found != nullptr);
    const QString window = !found                                     ? tr("none")
                           : found->window == WindowKind::Perspective ? tr("Perspective")
                           : found->window == WindowKind::ThreeView   ? tr("Three-view")
                                                                      : tr("Constraint");
    shown->setText(tr("View &%1: %2").arg(number).arg(window));
  }
}

void MainWindow::store_bookmark(int number) {
  const SceneView* const view = active_view();
  m_bookmarks.store(number, {view->kind(), view->camera()});
  name_bookmarks();
  statusBar()->showMessage(tr("Stored as view %1: Alt+%1 shows it again").arg(number),
                           kStoredNoteMs);
}

void MainWindow::show_bookmark(int number) {
  const Bookmark* const found = m_bookmarks.find(number);
  if (!found) return;
  SceneView& shown = view(found->window);
  shown.set_camera(found->camera);
  if (&shown == m_constraint) m_constraint_is_free = true;
  if (&shown != m_three) return;
  const Vec3 back = shown.view().axes().back.cwiseAbs();
  m_three_shows = back.z() > 0.9 ? "top" : back.x() > 0.9 ? "side" : "front";
  action(m_three_shows)->setChecked(true);
}

}  // namespace trivet::edit
