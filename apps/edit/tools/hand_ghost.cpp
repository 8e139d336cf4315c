#include "apps/edit/tools/hand_ghost.h"

#include <cmath>

namespace trivet::edit {
namespace {

constexpr double kLeastMetres = 1e-5;  // shorter ways are none
constexpr double kLeastTurned = 1e-9;  // 1 less the cosine of half the angle

bool same_place(const Pose& a, const Pose& b) {
  const Rotation &p = a.rotation, &q = b.rotation;
  const double cosine = p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z;
  return (a.translation - b.translation).norm() < kLeastMetres &&
         1 - std::abs(cosine) < kLeastTurned;
}

}  // namespace

bool put_as_shown(Document& document, ObjectId object, const Object& start,
                  std::vector<Operation> choices) {
  const std::optional<Ghost>& ghost = document.ghost();
  const bool rests = ghost && ghost->ok && ghost->object == object;
  if (rests && document.is_ghost_current()) {
    if (same_place(ghost->members.front().pose, start.pose)) return false;
    choices = {ghost->operation};
  } else if (rests) {
    choices.push_back(ghost->operation);
  }
  document.perform_first(std::move(choices));
  return true;
}

}  // namespace trivet::edit
