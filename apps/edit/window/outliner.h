// Tree of all objects by support.
#pragma once

#include <QTreeWidget>

#include "apps/edit/document/document.h"
#include "apps/edit/window/theme.h"

namespace trivet::edit {

/// "stable", "held", ..., in the colour of its importance.
QIcon state_icon(ObjectState state, const Theme& theme);

class Outliner : public QTreeWidget {
  Q_OBJECT

 public:
  explicit Outliner(Document& document, QWidget* parent = nullptr);
  void set_theme(const Theme& theme);
  /// Shows only objects whose names contain this, and what they rest on.
  void set_filter(const QString& part);
  /// Selects the objects whose names contain the filter.
  void select_found();
  /// Opens a field for the name of the active object.
  void edit_name();

 Q_SIGNALS:
  /// Emitted on a double click on an unplaced object.
  void put_wanted();
  void frame_wanted();

 private:
  void rebuild();
  void take_name(const QTreeWidgetItem& item);
  bool is_found(const QTreeWidgetItem& item) const;
  bool filter(QTreeWidgetItem& item);
  void show_filter();
  void show_selection();
  void take_selection();
  QTreeWidgetItem* add_heading(const QString& text);
  void add_placed(const SceneSnapshot& scene, QTreeWidgetItem* floor);
  QTreeWidgetItem* add(QTreeWidgetItem* parent, const ObjectSnapshot& object);

  Document& m_document;
  Theme m_theme;
  QString m_filter;
  std::uint64_t m_committed = 0;
  bool m_is_showing = false;  // suppresses reactions to its own changes of the selection
};

}  // namespace trivet::edit
