// Actions of the main window by their names, with keys, tips and icons.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QWidget>
#include <functional>
#include <initializer_list>
#include <map>
#include <vector>

#include "apps/edit/window/help.h"
#include "apps/edit/window/icons.h"

namespace trivet::edit {

class ActionSet {
 public:
  /// @param window  in which the keys work; it owns the actions.
  explicit ActionSet(QWidget& window) : m_window(window) {}

  /// The tip, or else the text, is shown with the keys.
  QAction* add(const QString& name, const QString& text, const QKeySequence& keys,
               std::function<void()> done, const QString& tip = {});
  /// @param name  of an action that was added.
  QAction* at(const QString& name) const { return m_actions.at(name); }
  void set_icon(QAction* action, Icon icon) { m_icons[action] = icon; }
  /// Draws the icons in this colour.
  void draw_icons(const QColor& colour) const;
  /// Fills a menu or a tool bar. @param names  of actions; "": a separator.
  template <class Bar>
  void fill(Bar& bar, std::initializer_list<const char*> names) const {
    for (const char* const name : names) {
      if (*name == '\0')
        bar.addSeparator();
      else
        bar.addAction(at(name));
    }
  }
  /// Keys and tips of all actions that have keys, in the order in which they were added.
  std::vector<ShortcutRow> shortcut_rows() const;

 private:
  QWidget& m_window;
  std::map<QString, QAction*> m_actions;
  std::map<QAction*, Icon> m_icons;
};

}  // namespace trivet::edit
