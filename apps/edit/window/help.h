// Built-in help: keys, and a table in two minutes.
#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace trivet::edit {

struct ShortcutRow {
  QString keys, what;
};

/// Shows a window that stays open beside the work.
void show_shortcuts(QWidget* parent, const std::vector<ShortcutRow>& menu_shortcuts);
void show_two_minutes(QWidget* parent);

}  // namespace trivet::edit
