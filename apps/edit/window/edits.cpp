// Menu actions on the selection.
#include <set>

#include "apps/edit/document/names.h"
#include "apps/edit/window/main_window.h"

namespace trivet::edit {
void MainWindow::perform_on_selection(const QString& name,
                                      const std::function<Operation(const std::string&)>& make) {
  const auto snapshot = m_document.snapshot();
  std::vector<Operation> operations;
  for (const ObjectId id : m_document.selection().objects)
    if (const ObjectSnapshot* const object = snapshot->find(id))
      operations.push_back(make((*object)->name));
  if (operations.size() == 1)
    m_document.perform(operations.front());
  else if (!operations.empty())
    m_document.perform_all(name.toStdString(), std::move(operations));
}

void MainWindow::duplicate() {
  const auto snapshot = m_document.snapshot();
  NewNames free(*snapshot);
  std::vector<std::string> names;
  std::vector<Operation> operations;
  for (const ObjectId id : m_document.selection().objects) {
    const ObjectSnapshot* const object = snapshot->find(id);
    if (!object) continue;
    DuplicateOperation operation;
    operation.object = (*object)->name;
    operation.as = free.like((*object)->name);
    names.push_back(operation.as);
    operations.push_back(operation);
  }
  if (operations.empty()) return;
  when_finished(
      m_document.perform_all("duplicate", std::move(operations), std::move(names)),
      [this](bool ok) {
        if (ok) take_tool(ToolKind::Put);
      });
}

void MainWindow::lock_selected(bool locked) {
  perform_on_selection(locked ? tr("lock") : tr("unlock"), [locked](const std::string& object) {
    LockOperation operation;
    operation.object = object;
    operation.locked = locked;
    return Operation(operation);
  });
}

void MainWindow::fix_selected(bool fixed) {
  perform_on_selection(fixed ? tr("fix") : tr("unfix"), [fixed](const std::string& object) {
    FixOperation operation;
    operation.object = object;
    operation.fixed = fixed;
    return Operation(operation);
  });
}

void MainWindow::group_selected(bool together) {
  std::string group;
  if (together) {
    std::set<std::string> taken;
    for (const ObjectSnapshot& object : m_document.snapshot()->objects) taken.insert(object->group);
    for (int i = 1; group.empty() || taken.count(group); ++i)
      group = tr("group %1").arg(i).toStdString();
  }
  perform_on_selection(together ? tr("group") : tr("ungroup"), [&](const std::string& object) {
    GroupOperation operation;
    operation.object = object;
    operation.group = group;
    return Operation(operation);
  });
}

void MainWindow::select_all() {
  Selection selection;
  for (const ObjectSnapshot& object : m_document.snapshot()->objects)
    selection.objects.push_back(object.id);
  m_document.select(std::move(selection));
}

}  // namespace trivet::edit
