#include "apps/edit/window/import_dialog.h"

#include <QAbstractItemView>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPixmap>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <map>

#include "apps/edit/window/asset_facts.h"
#include "apps/edit/window/units.h"

namespace trivet::edit {
namespace {

constexpr int kModel = 0, kSize = 1, kUnit = 2, kScale = 3, kUp = 4, kNotes = 5, kNumColumns = 6;
constexpr int kAsStated = 0, kY = 1, kZ = 2;  // in the list of axes

constexpr int kPicturePx = 56;
constexpr double kOther = -1;  // data of a unit that is none of the list
constexpr QSize kDialogSize(940, 420);

QString folder_of(const QString& file) { return QFileInfo(file).absolutePath(); }

}  // namespace

ImportDialog::ImportDialog(const QStringList& files, const QString& cache,
                           const ImportLimits& limits, QWidget* parent)
    : QDialog(parent),
      m_files(files),
      m_thumbnails(cache, limits),
      m_table(new QTableWidget),
      m_fixed(new QCheckBox(tr("Fixed: stays where it is put, and supports any load"))),
      m_state(new QLabel) {
  setWindowTitle(files.size() == 1
                     ? tr("Import %1").arg(QFileInfo(files.front()).fileName())
                     : tr("Import %n models", nullptr, static_cast<int>(files.size())));
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  m_import = buttons->button(QDialogButtonBox::Ok);
  m_import->setText(tr("Import"));
  m_state->setObjectName("faint");
  m_state->setWordWrap(true);
  make_table();
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 12);
  if (files.size() > 1) column->addWidget(make_choices_for_all());
  column->addWidget(m_table, 1);
  column->addWidget(m_fixed);
  column->addWidget(m_state);
  column->addWidget(buttons);
  resize(kDialogSize);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&m_thumbnails, &AssetThumbnails::made, this, &ImportDialog::show_made);
  m_thumbnails.want(m_files, {});
  show_state();
}

// --- widgets -----------------------------------------------------------------------------------

void ImportDialog::make_table() {
  m_table->setObjectName("models");
  m_table->setColumnCount(kNumColumns);
  m_table->setHorizontalHeaderLabels(
      {tr("Model"), tr("Size"), tr("Unit"), tr("Metres per unit"), tr("Up"), tr("Notes")});
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(kPicturePx + 6);
  m_table->setIconSize(QSize(kPicturePx, kPicturePx));
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setSelectionMode(QAbstractItemView::NoSelection);
  m_table->setRowCount(static_cast<int>(m_files.size()));
  m_rows.reserve(static_cast<size_t>(m_files.size()));
  for (int row = 0; row < m_files.size(); ++row) make_row(row);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->setColumnWidth(kModel, 210);
  m_table->setColumnWidth(kSize, 190);
  m_table->setColumnWidth(kUnit, 130);
  m_table->setColumnWidth(kScale, 110);
  m_table->setColumnWidth(kUp, 110);
}

void ImportDialog::make_row(int row) {
  const QString& file = m_files[row];
  for (const int column : {kModel, kSize, kNotes})
    m_table->setItem(row, column, new QTableWidgetItem);
  m_table->item(row, kModel)->setText(QFileInfo(file).fileName());
  m_table->item(row, kModel)->setToolTip(file);
  Row made{file, make_units(), make_axes(), new QDoubleSpinBox};
  made.scale->setDecimals(6);
  made.scale->setRange(1e-6, 1e6);
  made.scale->setValue(1);
  m_table->setCellWidget(row, kUnit, made.unit);
  m_table->setCellWidget(row, kScale, made.scale);
  m_table->setCellWidget(row, kUp, made.up);
  const FolderChoice before = FolderChoice::of(folder_of(file));
  if (const int unit = made.unit->findData(before.metres); unit >= 0) {
    made.unit->setCurrentIndex(unit);
  } else {
    made.scale->setValue(before.metres);
    made.unit->setCurrentIndex(made.unit->findData(kOther));
  }
  if (before.up) made.up->setCurrentIndex(*before.up == UpAxis::Y ? kY : kZ);
  m_rows.push_back(made);
  connect(made.unit, &QComboBox::currentIndexChanged, this, [this, made] { show_scale(made); });
  connect(made.scale, &QDoubleSpinBox::valueChanged, this, [made](double value) {
    const int unit = made.unit->findData(value);
    made.unit->setCurrentIndex(unit >= 0 ? unit : made.unit->findData(kOther));
  });
  show_scale(made);
}

QComboBox* ImportDialog::make_units() {
  auto* const units = new QComboBox;
  units->addItem(tr("likely"), 0.0);
  for (const LengthUnit& unit : length_units()) units->addItem(unit.name, unit.metres);
  units->addItem(tr("other"), kOther);
  return units;
}

QComboBox* ImportDialog::make_axes() {
  auto* const axes = new QComboBox;
  axes->addItems({tr("likely"), tr("Y"), tr("Z")});
  return axes;
}

QWidget* ImportDialog::make_choices_for_all() {
  auto* const all = new QWidget;
  auto* const line = new QHBoxLayout(all);
  line->setContentsMargins(0, 0, 0, 0);
  QComboBox *const units = make_units(), *const axes = make_axes();
  units->setObjectName("unit of all"), axes->setObjectName("up of all");
  line->addWidget(new QLabel(tr("All: unit")));
  line->addWidget(units);
  line->addWidget(new QLabel(tr("up")));
  line->addWidget(axes);
  line->addStretch(1);
  connect(units, &QComboBox::activated, this, [this](int index) {
    for (const Row& row : m_rows) row.unit->setCurrentIndex(index);
  });
  connect(axes, &QComboBox::activated, this, [this](int index) {
    for (const Row& row : m_rows) row.up->setCurrentIndex(index);
  });
  return all;
}

// --- what is known -----------------------------------------------------------------------------

void ImportDialog::show_made(const QString& file) {
  const AssetInfo* const info = m_thumbnails.find(file);
  for (int row = 0; info && row < m_files.size(); ++row)
    if (m_files[row] == file) show_info(row, *info);
  show_state();
}

void ImportDialog::show_info(int number, const AssetInfo& info) {
  const Row& row = m_rows[static_cast<size_t>(number)];
  const bool is_bad = !info.error.empty();
  for (QWidget* const widget : std::initializer_list<QWidget*>{row.unit, row.scale, row.up})
    widget->setEnabled(!is_bad);
  QTableWidgetItem* const notes = m_table->item(number, kNotes);
  const QStringList said = notes_text(info);
  notes->setText(said.join("; "));
  notes->setToolTip(said.join('\n'));
  if (is_bad) return notes->setForeground(Qt::red);
  m_table->item(number, kModel)->setIcon(QPixmap::fromImage(info.picture));
  m_table->item(number, kSize)->setText(size_text(info));
  row.unit->setItemText(0, info.unit.isEmpty() ? tr("as stated") : tr("likely %1").arg(info.unit));
  row.up->setItemText(0, info.states_up ? tr("as stated: %1").arg(info.up == UpAxis::Y ? "y" : "z")
                                        : tr("likely %1").arg(info.up == UpAxis::Y ? "y" : "z"));
  show_scale(row);
}

void ImportDialog::show_scale(const Row& row) {
  const double metres = chosen_metres(row);
  if (row.scale->value() == metres) return;  // it may be what is being typed
  const QSignalBlocker blocker(row.scale);
  row.scale->setValue(metres);
}

void ImportDialog::show_state() {
  int num_known = 0, num_bad = 0;
  for (const QString& file : m_files) {
    const AssetInfo* const info = m_thumbnails.find(file);
    num_known += info != nullptr;
    num_bad += info && !info->error.empty();
  }
  const int num_all = static_cast<int>(m_files.size());
  m_import->setEnabled(num_known == num_all && num_bad < num_all);
  QString text = tr("Imported models are not placed yet; click where to put them.");
  if (num_known < num_all)
    text = tr("Reading: %1 of %2 files").arg(num_known).arg(num_all);
  else if (num_bad > 0)
    text = tr("%n files cannot be read and are left out.", nullptr, num_bad) + " " + text;
  m_state->setText(text);
}

// --- what is chosen ----------------------------------------------------------------------------

double ImportDialog::chosen_metres(const Row& row) const {
  const double unit = row.unit->currentData().toDouble();
  if (unit > 0) return unit;
  const AssetInfo* const info = m_thumbnails.find(row.file);
  return unit == 0 && info ? info->metres : row.scale->value();
}

std::optional<UpAxis> ImportDialog::chosen_up(const Row& row) const {
  if (row.up->currentIndex() != kAsStated)
    return row.up->currentIndex() == kY ? UpAxis::Y : UpAxis::Z;
  const AssetInfo* const info = m_thumbnails.find(row.file);
  return info && !info->states_up ? std::optional(info->up) : std::nullopt;
}

std::vector<ImportModel> ImportDialog::models() const {
  std::vector<ImportModel> models;
  for (const Row& row : m_rows) {
    const AssetInfo* const info = m_thumbnails.find(row.file);
    if (!info || !info->error.empty()) continue;
    ImportModel model;
    model.file = row.file.toStdString();
    model.scale = chosen_metres(row);
    model.up = chosen_up(row);
    model.fixed = m_fixed->isChecked();
    models.push_back(std::move(model));
  }
  return models;
}

// The last of several files of one folder counts.
void ImportDialog::remember_choices() const {
  std::map<QString, FolderChoice> choices;
  for (const Row& row : m_rows) {
    FolderChoice& choice = choices[folder_of(row.file)];
    const bool is_likely = row.unit->currentData().toDouble() == 0;
    choice.metres = is_likely ? 0 : chosen_metres(row);
    choice.up = row.up->currentIndex() == kAsStated ? std::nullopt : chosen_up(row);
  }
  for (const auto& [folder, choice] : choices) choice.remember(folder);
}

QString ImportDialog::filter() {
  return tr("Models (%1)").arg(AssetThumbnails::patterns().join(' ')) + ";;" + tr("All files (*)");
}

}  // namespace trivet::edit
