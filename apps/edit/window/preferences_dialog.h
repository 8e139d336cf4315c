// Preferences: who answers first-contact queries, at once; the language, at the next start.
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>

#include "apps/edit/window/detection_choice.h"

namespace trivet::edit {

class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  /// @param document  tells who answers.
  PreferencesDialog(Document& document, const DetectionChoice& choice, QWidget* parent);

 Q_SIGNALS:
  void detection_chosen(const trivet::edit::DetectionChoice& choice);

 private:
  QComboBox* make_box(const char* name,
                      std::initializer_list<std::pair<const char*, QString>> items,
                      const QString& current);
  QComboBox* make_languages();
  DetectionChoice choice() const;
  void show_answering();

  Document& m_document;
  QComboBox *m_backend, *m_method;
  QLabel* m_answering;
};

}  // namespace trivet::edit
