#include "apps/edit/window/import_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "apps/edit/window/asset_thumbnails.h"
#include "apps/edit/window/units.h"

namespace trivet::edit {
ImportDialog::ImportDialog(const QStringList& files, QWidget* parent)
    : QDialog(parent),
      m_files(files),
      m_unit(new QComboBox),
      m_scale(new QDoubleSpinBox),
      m_up(new QComboBox),
      m_fixed(new QCheckBox(tr("Fixed: stays where it is put, and supports any load"))) {
  setWindowTitle(files.size() == 1 ? tr("Import %1").arg(QFileInfo(files.front()).fileName())
                                   : tr("Import %1 models").arg(files.size()));
  auto* const form = new QFormLayout(this);
  form->setContentsMargins(16, 16, 16, 12);
  form->setVerticalSpacing(8);
  for (const LengthUnit& unit : length_units()) m_unit->addItem(unit.name, unit.metres);
  m_unit->addItem(tr("other"), 0.0);
  m_scale->setDecimals(6);
  m_scale->setRange(1e-6, 1e6);
  m_scale->setValue(1);
  m_scale->setSuffix(tr(" m per unit"));
  m_up->addItems({tr("As the format states"), tr("Y"), tr("Z")});
  form->addRow(tr("Unit of the file"), m_unit);
  form->addRow(tr("Scale"), m_scale);
  form->addRow(tr("Up axis"), m_up);
  form->addRow(m_fixed);
  auto* const note = new QLabel(tr("The imported model is not placed yet; click where to put it."));
  note->setObjectName("faint");
  note->setWordWrap(true);
  form->addRow(note);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Import"));
  form->addRow(buttons);
  connect(m_unit, &QComboBox::currentIndexChanged, this, [this] {
    if (const double metres = m_unit->currentData().toDouble(); metres > 0)
      m_scale->setValue(metres);
  });
  connect(m_scale, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (m_unit->currentData().toDouble() != value) m_unit->setCurrentIndex(m_unit->count() - 1);
  });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

std::vector<ImportModel> ImportDialog::models() const {
  std::vector<ImportModel> models;
  for (const QString& file : m_files) {
    ImportModel model;
    model.file = file.toStdString();
    model.scale = m_scale->value();
    if (m_up->currentIndex() > 0) model.up = m_up->currentIndex() == 1 ? UpAxis::Y : UpAxis::Z;
    model.fixed = m_fixed->isChecked();
    models.push_back(std::move(model));
  }
  return models;
}

QString ImportDialog::filter() {
  return tr("Models (%1)").arg(AssetThumbnails::patterns().join(' ')) + ";;" + tr("All files (*)");
}

}  // namespace trivet::edit
