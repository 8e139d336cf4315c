// Start page: demos, recent files, sessions to recover.
#pragma once

#include <QVBoxLayout>
#include <QWidget>

#include "apps/edit/document/document.h"

namespace trivet::edit {

class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);
  void show_choices(const QStringList& recent, const std::vector<Recoverable>& recoverable);

 Q_SIGNALS:
  void new_wanted();
  void open_wanted();
  void import_wanted();
  void help_wanted();
  void file_wanted(const QString& file);
  void demo_wanted(const QString& name);
  void recovery_wanted(const QString& journal);
  void discard_wanted(const QString& journal);

 private:
  void add_title(QVBoxLayout& column);
  void add_beginnings(QVBoxLayout& column);
  void add_recent(QVBoxLayout& column, const QStringList& recent);
  void add_recoverable(QVBoxLayout& column, const Recoverable& session);
  QWidget* m_content = nullptr;
  QVBoxLayout* m_column;
};

}  // namespace trivet::edit
