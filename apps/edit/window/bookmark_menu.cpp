#include "apps/edit/window/bookmark_menu.h"

namespace trivet::edit {
namespace {

QString bookmark_name(int number) { return QString("bookmark %1").arg(number); }
QString store_name(int number) { return QString("store bookmark %1").arg(number); }

}  // namespace

BookmarkMenu::BookmarkMenu(Document& document, Workspace& workspace, ActionSet& actions,
                           QWidget* parent)
    : QMenu(tr("&Bookmarks"), parent),
      m_document(document),
      m_workspace(workspace),
      m_actions(actions) {
  setObjectName("bookmarks");
  for (int number = 1; number <= Bookmarks::kMost; ++number)
    addAction(m_actions.add(
        bookmark_name(number), tr("View &%1").arg(number),
        QKeySequence(Qt::ALT | (Qt::Key_0 + number)), [this, number] { show_view(number); },
        tr("Show the view stored as %1").arg(number)));
  addSeparator();
  for (int number = 1; number <= Bookmarks::kMost; ++number)
    addAction(m_actions.add(
        store_name(number), tr("Store as view %1").arg(number),
        QKeySequence(Qt::CTRL | (Qt::Key_0 + number)), [this, number] { store(number); },
        tr("Store the view under the mouse as %1").arg(number)));
  connect(&m_document, &Document::scene_replaced, this, [this] { m_is_replaced = true; });
  connect(&m_document, &Document::history_changed, this, &BookmarkMenu::follow);
  name_actions();
}

// The scene's file was opened, or it was saved under another name.
void BookmarkMenu::follow() {
  const QString file = QString::fromStdString(m_document.file());
  if (m_is_replaced)
    m_bookmarks.load(file), reset_cameras_if_empty();
  else if (!file.isEmpty() && file != m_of)
    m_bookmarks.keep_for(file);
  else if (m_document.history().num_done < m_num_done)
    reset_cameras_if_empty();
  m_is_replaced = false;
  m_of = file;
  m_num_done = m_document.history().num_done;
  name_actions();
}

void BookmarkMenu::reset_cameras_if_empty() {
  if (m_document.snapshot()->box().empty()) m_workspace.reset_cameras();
}

void BookmarkMenu::name_actions() {
  for (int number = 1; number <= Bookmarks::kMost; ++number) {
    const Bookmark* const found = m_bookmarks.find(number);
    QAction* const shown = m_actions.at(bookmark_name(number));
    shown->setEnabled(found != nullptr);
    const QString window = !found                                     ? tr("none")
                           : found->window == WindowKind::Perspective ? tr("Perspective")
                           : found->window == WindowKind::ThreeView   ? tr("Three-view")
                                                                      : tr("Constraint");
    shown->setText(tr("View &%1: %2").arg(number).arg(window));
  }
}

void BookmarkMenu::store(int number) {
  const SceneView& view = m_workspace.active_view();
  m_bookmarks.store(number, {view.kind(), view.camera()});
  name_actions();
  Q_EMIT stored(number);
}

void BookmarkMenu::show_view(int number) {
  if (const Bookmark* const found = m_bookmarks.find(number))
    m_workspace.show_camera(found->window, found->camera);
}

}  // namespace trivet::edit
