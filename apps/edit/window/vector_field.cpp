#include "apps/edit/window/vector_field.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSizePolicy>

namespace trivet::edit {

VectorField::VectorField(const QString& name, double largest, int decimals, double step,
                         QWidget* parent)
    : QWidget(parent), m_boxes{} {
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(3);
  const char* const axes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    auto* const box = m_boxes[axis] = new QDoubleSpinBox;
    box->setObjectName(name + " " + axes[axis]);
    box->setRange(-largest, largest);
    box->setDecimals(decimals);
    box->setSingleStep(step);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setKeyboardTracking(false);
    box->setFocusPolicy(Qt::StrongFocus);
    box->setMinimumWidth(40);
    box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    box->setToolTip(QString(axes[axis]));
    box->installEventFilter(this);
    row->addWidget(box, 1);
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, axis](double value) { Q_EMIT edited(axis, value); });
  }
}

void VectorField::show_values(const Vec3& values) {
  for (int axis = 0; axis < 3; ++axis) {
    QDoubleSpinBox* const box = m_boxes[axis];
    const bool typing = box->hasFocus() && box->findChild<QLineEdit*>()->isModified();
    const QSignalBlocker blocker(box);
    if (!typing || box->value() == values[axis]) box->setValue(values[axis]);
  }
}

// The wheel scrolls the panel unless the box has the focus.
bool VectorField::eventFilter(QObject* watched, QEvent* event) {
  auto* const box = qobject_cast<QWidget*>(watched);
  if (event->type() != QEvent::Wheel || !box || box->hasFocus()) return false;
  event->ignore();
  return true;
}

}  // namespace trivet::edit
