// The fourth window: objects, selection, operations, history, files.
#pragma once

#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
#include <QTabWidget>

#include "apps/edit/window/operation_panel.h"
#include "apps/edit/window/outliner.h"
#include "apps/edit/window/properties.h"

namespace trivet::edit {

class ControlWindow : public QSplitter {
  Q_OBJECT

 public:
  ControlWindow(Document& document, Toolbox& toolbox, QWidget* parent = nullptr);

  Outliner& outliner() { return *m_outliner; }
  QLineEdit& search() { return *m_search; }
  OperationPanel& operations() { return *m_operations; }
  void show_operations() { m_tabs->setCurrentWidget(m_operations); }
  void set_theme(const Theme& theme);
  void show_files(const QStringList& recent);

 Q_SIGNALS:
  void file_wanted(const QString& file);
  void demo_wanted(const QString& name);

 private:
  QWidget* make_search();
  void show_history();
  void choose_file(const QListWidgetItem& item);

  Document& m_document;
  Theme m_theme;
  Outliner* m_outliner;
  QLineEdit* m_search;
  Properties* m_properties;
  OperationPanel* m_operations;
  QListWidget* m_history;
  QListWidget* m_files;
  QTabWidget* m_tabs;
};

}  // namespace trivet::edit
