#include "apps/edit/window/form_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QStringList>

namespace trivet::edit {

FormDialog::FormDialog(QWidget* parent, const QString& title, const QString& done)
    : QDialog(parent), m_form(new QFormLayout(this)), m_done(done) {
  setWindowTitle(title);
  m_form->setContentsMargins(16, 16, 16, 12);
  m_form->setVerticalSpacing(8);
  m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  m_form->setSizeConstraint(QLayout::SetFixedSize);  // follows the rows that are shown
}

template <class Box>
Box* FormDialog::add(const QString& name, Box* box) {
  box->setObjectName(name);
  m_form->addRow(name, box);
  return box;
}

QDoubleSpinBox* FormDialog::metres(const QString& name, double value, double lower) {
  auto* const box = add(name, new QDoubleSpinBox);
  box->setRange(lower, 1000);
  box->setDecimals(4);
  box->setSingleStep(0.01);
  box->setSuffix(tr(" m"));
  box->setValue(value);
  return box;
}

QDoubleSpinBox* FormDialog::degrees(const QString& name, double value) {
  auto* const box = add(name, new QDoubleSpinBox);
  box->setRange(-360, 360);
  box->setDecimals(2);
  box->setSingleStep(15);
  box->setSuffix(tr("°"));
  box->setValue(value);
  return box;
}

QSpinBox* FormDialog::number(const QString& name, int value, int lower, int upper) {
  auto* const box = add(name, new QSpinBox);
  box->setRange(lower, upper);
  box->setValue(value);
  return box;
}

QComboBox* FormDialog::choice(const QString& name, const QStringList& items, int current) {
  auto* const box = add(name, new QComboBox);
  box->addItems(items);
  box->setCurrentIndex(current);
  return box;
}

QCheckBox* FormDialog::yes_or_no(const QString& name, bool on) {
  auto* const box = new QCheckBox(name);
  box->setObjectName(name);
  box->setChecked(on);
  m_form->addRow(box);
  return box;
}

void FormDialog::note(const QString& text) {
  auto* const label = new QLabel(text);
  label->setObjectName("faint");
  label->setWordWrap(true);
  label->setFixedWidth(320);
  m_form->addRow(label);
}

void FormDialog::show_rows(const std::vector<QWidget*>& widgets, bool shown) {
  for (QWidget* const widget : widgets) {
    widget->setVisible(shown);
    if (QWidget* const title = m_form->labelForField(widget)) title->setVisible(shown);
  }
}

bool FormDialog::ask() {
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setText(m_done);
  m_form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return exec() == Accepted;
}

}  // namespace trivet::edit
