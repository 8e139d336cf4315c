#include "apps/edit/window/action_set.h"

namespace trivet::edit {

QAction* ActionSet::add(const QString& name, const QString& text, const QKeySequence& keys,
                        std::function<void()> done, const QString& tip) {
  auto* const action = new QAction(text, &m_window);
  action->setObjectName(name);
  action->setShortcut(keys);
  QString shown = tip.isEmpty() ? QString(text).remove('&').remove("…") : tip;
  if (!keys.isEmpty()) shown += "  (" + keys.toString(QKeySequence::NativeText) + ")";
  action->setToolTip(shown);
  QObject::connect(action, &QAction::triggered, &m_window, [done = std::move(done)] { done(); });
  m_window.addAction(action);
  m_actions[name] = action;
  return action;
}

void ActionSet::draw_icons(const QColor& colour) const {
  for (const auto& [action, icon] : m_icons) action->setIcon(make_icon(icon, colour));
}

std::vector<ShortcutRow> ActionSet::shortcut_rows() const {
  std::vector<ShortcutRow> rows;
  for (const QAction* const action : m_window.actions())
    if (!action->shortcut().isEmpty())
      rows.push_back({action->shortcut().toString(QKeySequence::NativeText),
                      QString(action->toolTip()).section("  (", 0, 0)});
  return rows;
}

}  // namespace trivet::edit
