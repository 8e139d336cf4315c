// Properties: the joint in which an object hangs, as a slider between its limits.
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <cmath>

#include "apps/edit/window/properties.h"
#include "core/scene/joint.h"

namespace trivet::edit {
namespace {

constexpr int kSliderSteps = 1000;
constexpr double kWayWithoutLimit = 1, kTurnWithoutLimit = 180;  // metres, degrees

struct SliderRange {
  double lower, upper;

  double at(int step) const { return lower + (upper - lower) * step / kSliderSteps; }
  int step_of(double value) const {
    if (!(upper > lower)) return 0;
    return static_cast<int>(std::lround((value - lower) / (upper - lower) * kSliderSteps));
  }
};

// A joint without a limit has some way from where it is.
SliderRange range_of(const LinkJoint& joint) {
  const double way = joint.turns() ? kTurnWithoutLimit : kWayWithoutLimit;
  return {std::isfinite(joint.lower) ? joint.lower : joint.value - way,
          std::isfinite(joint.upper) ? joint.upper : joint.value + way};
}

}  // namespace

void Properties::add_joint() {
  auto* const title = new QLabel(tr("Joint"));
  title->setObjectName("faint");
  auto* const row = new QHBoxLayout(m_joint);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_joint_slider, 1);
  row->addWidget(m_joint_value);
  m_joint_slider->setObjectName("joint");
  m_joint_slider->setRange(0, kSliderSteps);
  m_joint_value->setObjectName("joint value");
  m_joint_value->setKeyboardTracking(false);
  for (QWidget* const widget : {static_cast<QWidget*>(title), m_joint})
    widget->setToolTip(
        tr("Opens and closes it with all that lies in and on it, up to what is in the way"));
  m_form->addRow(title, m_joint);
  connect(m_joint_value, &QDoubleSpinBox::valueChanged, this, &Properties::take_joint);
  const auto here = [this](int step) {
    const Object* const object = active_object();
    return object && object->joint ? range_of(*object->joint).at(step) : 0;
  };
  // While it is held the number shows where it would go; let go, it goes there.
  connect(m_joint_slider, &QSlider::sliderMoved, this, [this, here](int step) {
    const QSignalBlocker value(m_joint_value);
    m_joint_value->setValue(here(step));
  });
  connect(m_joint_slider, &QSlider::sliderReleased, this,
          [this, here] { take_joint(here(m_joint_slider->value())); });
  connect(m_joint_slider, &QSlider::valueChanged, this, [this, here](int step) {
    if (!m_joint_slider->isSliderDown()) take_joint(here(step));
  });
}

void Properties::show_joint(const Object& object) {
  m_form->setRowVisible(m_joint, object.joint != nullptr);
  if (!object.joint || m_joint_slider->isSliderDown()) return;
  const LinkJoint& joint = *object.joint;
  const SliderRange range = range_of(joint);
  const QSignalBlocker value(m_joint_value), slider(m_joint_slider);
  m_joint_value->setDecimals(joint.turns() ? 2 : 4);
  m_joint_value->setSingleStep(joint.turns() ? 5 : 0.01);
  m_joint_value->setSuffix(joint.turns() ? QStringLiteral("°") : tr(" m"));
  m_joint_value->setRange(range.lower, range.upper);
  m_joint_value->setValue(joint.value);
  m_joint_slider->setValue(range.step_of(joint.value));
}

void Properties::take_joint(double value) {
  const Object* const object = active_object();
  if (!object || !object->joint || object->joint->value == value) return;
  MoveJointOperation move;
  move.object = object->name;
  move.to = value;
  m_document.perform(move);
}

}  // namespace trivet::edit
