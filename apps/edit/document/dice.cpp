#include "apps/edit/document/dice.h"

#include "apps/edit/document/pose_numbers.h"

namespace trivet::edit {

double Dice::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(m_engine() >> 11) * 0x1p-53);
}

Rotation Dice::rotation() {
  for (;;) {
    const Rotation r{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    const double squared = r.w * r.w + r.x * r.x + r.y * r.y + r.z * r.z;
    if (squared > 0.01 && squared <= 1) return r.normalized();
  }
}

Rotation Dice::turned(RandomTurn how, const Rotation& r) {
  if (how == RandomTurn::Any) return rotation();
  if (how == RandomTurn::None) return r;
  return (turned_about(Vec3::UnitZ(), uniform(0, 360)) * r).normalized();
}

}  // namespace trivet::edit
