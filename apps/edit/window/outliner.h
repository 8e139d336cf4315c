// Tree of all objects: collections with their objects, then all by support.
#pragma once

#include <QTreeWidget>

#include "apps/edit/document/document.h"
#include "apps/edit/window/theme.h"

namespace trivet::edit {

/// "stable", "held", ..., in the colour of its importance.
QIcon state_icon(ObjectState state, const Theme& theme);

/// The same in the language of the window.
QString state_text(ObjectState state);

class Outliner : public QTreeWidget {
  Q_OBJECT

 public:
  explicit Outliner(Document& document, QWidget* parent = nullptr);
  void set_theme(const Theme& theme);
  /// Shows only objects whose names contain this, and what they rest on.
  void set_filter(const QString& part);
  /// Selects the objects whose names contain the filter.
  void select_found();
  /// Opens a field for the name of the collection that is chosen, else of the active object.
  void edit_name();
  /// The same for a collection.
  void edit_name_of(const std::string& collection);

 Q_SIGNALS:
  /// Emitted on a double click on an unplaced object.
  void put_wanted();
  void frame_wanted();
  void context_menu_wanted(const QPoint& global);

 protected:
  // outliner_collections.cpp: objects are dragged into collections, and out of them
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void rebuild();
  void take_name(const QTreeWidgetItem& item);
  bool is_found(const QTreeWidgetItem& item) const;
  bool filter(QTreeWidgetItem& item);
  void show_filter();
  void show_selection();
  void take_selection();
  QTreeWidgetItem* add_heading(const QString& text);
  void add_collections(const SceneSnapshot& scene);
  void take_collection_name(const QTreeWidgetItem& item);
  void change_collections(const std::function<void(Collections&)>& change);
  void show_collection_menu(const Collection& collection, const QPoint& global);
  void add_placed(const SceneSnapshot& scene, QTreeWidgetItem* floor);
  QTreeWidgetItem* add(QTreeWidgetItem* parent, const ObjectSnapshot& object);

  Document& m_document;
  Theme m_theme;
  QString m_filter;
  std::uint64_t m_committed = 0;
  bool m_is_showing = false;  // suppresses reactions to its own changes of the selection
};

}  // namespace trivet::edit
