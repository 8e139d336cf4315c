// Menu actions on collections.
#include "apps/edit/window/main_window.h"

namespace trivet::edit {

void MainWindow::make_collection_actions() {
  add_action(
      "collect", tr("New &collection"), tr("Ctrl+Shift+C"), [this] { collect_selected(); },
      tr("Collection: the selected objects under one name, to be shown and selected together"));
  add_action(
      "uncollect", tr("Take out of its collection"), {},
      [this] {
        Looks looks = m_document.looks();
        looks.collections.take_out(m_document.selection().objects);
        m_document.set_looks(std::move(looks), tr("take out of its collection").toStdString());
      },
      tr("Take the selected objects out of their collections"));
}

void MainWindow::collect_selected() {
  Looks looks = m_document.looks();
  const std::string name = looks.collections.free_name(tr("collection").toStdString());
  looks.collections.put(m_document.selection().objects, name);
  m_document.set_looks(std::move(looks), tr("new collection").toStdString());
  control().outliner().edit_name_of(name);
}

}  // namespace trivet::edit
