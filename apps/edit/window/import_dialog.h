// Import options: scale, up axis, fixed or movable.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QStringList>

#include "apps/edit/document/document.h"

namespace trivet::edit {

class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ImportDialog(const QStringList& files, QWidget* parent = nullptr);

  /// One per file, with the chosen options.
  std::vector<ImportModel> models() const;

  /// Filter for file dialogs.
  static QString filter();

 private:
  QStringList m_files;
  QComboBox* m_unit;
  QDoubleSpinBox* m_scale;
  QComboBox* m_up;
  QCheckBox* m_fixed;
};

}  // namespace trivet::edit
