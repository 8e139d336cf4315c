// All actions by words: type a part of a name, Return does the first.
#pragma once

#include <QAction>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>

namespace trivet::edit {

class QuickActions : public QDialog {
  Q_OBJECT

 public:
  /// @param actions  those without a text and those that are disabled are left out.
  QuickActions(const QList<QAction*>& actions, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void filter();
  void run(QListWidgetItem* item);

  QLineEdit* m_words;
  QListWidget* m_list;
  QList<QAction*> m_actions;
};

}  // namespace trivet::edit
