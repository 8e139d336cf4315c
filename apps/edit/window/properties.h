// Properties of the active object: pose, mass, contacts, stability.
#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <map>

#include "apps/edit/document/document.h"
#include "apps/edit/window/theme.h"

namespace trivet::edit {

class Properties : public QScrollArea {
  Q_OBJECT

 public:
  explicit Properties(Document& document, QWidget* parent = nullptr);

 private:
  void show_object();
  void set(const QString& name, const QString& value, const QString& tip = {});

  Document& m_document;
  QLabel* m_name;
  QLabel* m_empty;
  QFormLayout* m_form;
  QWidget* m_content;
  std::map<QString, QLabel*> m_values;
};

/// "12.5 mm", "1.25 m"
QString length_text(double metres);

}  // namespace trivet::edit
