#include "core/io/foreign/scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/bad_input.h"
#include "core/motion/motion.h"

namespace trivet {
namespace {

constexpr size_t kMostNotes = 100, kMostFaces = 8'000'000;

}  // namespace

Pose composed(const Pose& a, const Pose& b) {
  return {a.rotation * b.rotation, a.translation + a.rotation.matrix() * b.translation};
}

Pose inverse(const Pose& pose) {
  const Rotation& r = pose.rotation;
  const Rotation back{r.w, -r.x, -r.y, -r.z};
  return {back, -(back.matrix() * pose.translation)};
}

Rotation turn_about(const Vec3& axis, double degrees) {
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

void note_once(std::vector<Sentence>& notes, Sentence note) {
  if (notes.size() > kMostNotes) return;
  if (notes.size() == kMostNotes) note = Sentence("there is more of this kind");
  const std::string text = in_english(note);
  const bool known = std::any_of(notes.begin(), notes.end(),
                                 [&](const Sentence& n) { return in_english(n) == text; });
  if (!known) notes.push_back(std::move(note));
}

std::string UniqueNames::operator()(std::string name) {
  if (name == "floor") name = "floor (body)";
  const std::string base = name;
  while (!m_taken.emplace(name, 1).second) name = base + "_" + std::to_string(++m_taken[base]);
  return name;
}

void count_faces(const Mesh& mesh, ForeignScene& scene) {
  scene.num_faces += mesh.triangles.size();
  if (scene.num_faces > kMostFaces)
    bad_file(scene.files.at(0).path, "has too many faces that collide; accepted: %1", kMostFaces);
}

}  // namespace trivet
