// A dialog of rows with numbers and choices; Cancel or the named button ends it.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSpinBox>
#include <vector>

namespace trivet::edit {

class FormDialog : public QDialog {
 public:
  /// @param done  text of the button that accepts.
  FormDialog(QWidget* parent, const QString& title, const QString& done);

  /// Rows, in this order. Object names are those of the rows, for tests.
  QDoubleSpinBox* metres(const QString& name, double value, double lower = -1000);
  QDoubleSpinBox* degrees(const QString& name, double value);
  QSpinBox* number(const QString& name, int value, int lower, int upper);
  QComboBox* choice(const QString& name, const QStringList& items, int current = 0);
  QCheckBox* yes_or_no(const QString& name, bool on);
  void note(const QString& text);
  /// Shows the rows of these widgets only while `shown`.
  void show_rows(const std::vector<QWidget*>& widgets, bool shown);

  /// Runs it. @return whether it was accepted.
  bool ask();

 private:
  template <class Box>
  Box* add(const QString& name, Box* box);

  QFormLayout* m_form;
  QString m_done;
};

}  // namespace trivet::edit
