// Three numbers that can be edited, side by side.
#pragma once

#include <QDoubleSpinBox>
#include <QWidget>
#include <array>

#include "core/base/types.h"

namespace trivet::edit {

class VectorField : public QWidget {
  Q_OBJECT

 public:
  /// @param name  of the boxes: its object names are "name x", "name y", "name z".
  VectorField(const QString& name, double largest, int decimals, double step,
              QWidget* parent = nullptr);

  /// Shows values; a box that is being typed in keeps its text.
  void show_values(const Vec3& values);

 Q_SIGNALS:
  void edited(int axis, double value);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::array<QDoubleSpinBox*, 3> m_boxes;
};

}  // namespace trivet::edit
