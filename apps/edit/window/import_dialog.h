// Models that are to be imported, a row per file; their units and up axes.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QTableWidget>

#include "apps/edit/document/document.h"
#include "apps/edit/window/asset_thumbnails.h"

namespace trivet::edit {

/// Starts with what was chosen for the files' folders before, else with what the files state, else
/// with what is likely.
class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  /// @param cache, limits  as of AssetThumbnails.
  ImportDialog(const QStringList& files, const QString& cache, const ImportLimits& limits,
               QWidget* parent = nullptr);

  /// One per file that could be read, with the chosen options.
  std::vector<ImportModel> models() const;
  /// Chosen units and axes, for the next import from their folders.
  void remember_choices() const;

  /// Filter for file dialogs.
  static QString filter();

 private:
  struct Row {
    QString file;
    QComboBox *unit, *up;
    QDoubleSpinBox* scale;
  };
  void make_table();
  void make_row(int row);
  QWidget* make_choices_for_all();
  QComboBox* make_units();
  QComboBox* make_axes();
  void show_made(const QString& file);
  void show_info(int row, const AssetInfo& info);
  void show_scale(const Row& row);
  void show_state();
  double chosen_metres(const Row& row) const;
  std::optional<UpAxis> chosen_up(const Row& row) const;

  QStringList m_files;
  AssetThumbnails m_thumbnails;
  std::vector<Row> m_rows;
  QTableWidget* m_table;
  QCheckBox* m_fixed;
  QLabel* m_state;
  QPushButton* m_import = nullptr;
};

}  // namespace trivet::edit
