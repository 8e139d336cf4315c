// Menu actions on the selection.
#include <set>

#include "apps/edit/document/names.h"
#include "apps/edit/window/main_window.h"

namespace trivet::edit {
void MainWindow::perform_on_selection(const QString& name,
                                      const std::function<Operation(const std::string&)>& make) {
  std::vector<Operation> operations;
  for (const std::string& object : selected_names()) operations.push_back(make(object));
  if (operations.size() == 1)
    m_document.perform(operations.front());
  else if (!operations.empty())
    m_document.perform_all(name.toStdString(), std::move(operations));
}

void MainWindow::duplicate() {
  NewNames free(*m_document.snapshot());
  std::vector<std::string> names;
  std::vector<Operation> operations;
  for (const std::string& name : selected_names()) {
    names.push_back(free.like(name));
    operations.push_back(DuplicateOperation{name, names.back()});
  }
  if (operations.empty()) return;
  when_finished(m_document.perform_all(tr("duplicate").toStdString(), std::move(operations),
                                       std::move(names)),
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
