#include "core/io/foreign/scene.h"

#include <algorithm>
#include <cmath>

#include "core/motion/motion.h"

namespace trivet {

Pose composed(const Pose& a, const Pose& b) {
  return {a.rotation * b.rotation, a.translation + a.rotation.matrix() * b.translation};
}

Pose inverse(const Pose& pose) {
  const Rotation& r = pose.rotation;
  const Rotation back{r.w, -r.x, -r.y, -r.z};
  return {back, -(back.matrix() * pose.translation)};
}

Rotation turned(const Vec3& axis, double degrees) {
  // Quarter turns are exact, so that axes stay axes.
  const double angle = std::fmod(degrees, 720.0);  // a quaternion's period; exact
  const double quarters = std::round(angle / 90);
  const double h = std::sqrt(0.5);
  const double cosines[] = {1, h, 0, -h, -1, -h, 0, h};
  const int k = (static_cast<int>(quarters) + 8) % 8;
  const double c = cosines[k], s = cosines[(k + 6) % 8];
  const Rotation quarter{c, s * axis.x(), s * axis.y(), s * axis.z()};
  const double rest = angle - 90 * quarters;
  return rest == 0 ? quarter : quarter * Rotation::about_axis(axis, turn_time(rest));
}

void add_once(std::vector<Sentence>& notes, Sentence note) {
  const std::string text = in_english(note);
  const bool known = std::any_of(notes.begin(), notes.end(),
                                 [&](const Sentence& n) { return in_english(n) == text; });
  if (!known) notes.push_back(std::move(note));
}

}  // namespace trivet
