#include "core/io/foreign/scene.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/bad_input.h"
#include "core/io/foreign/primitives.h"

namespace trivet {
namespace {

constexpr size_t kMostNotes = 100, kMostFaces = 8'000'000;
constexpr double kMostBallFaces = 4e6;  // of balls that are made finer

const std::vector<std::pair<std::string, EngineRules>>& rules_by_name() {
  static const std::vector<std::pair<std::string, EngineRules>> out = {
      {"format", EngineRules::OfFormat},
      {"mujoco", EngineRules::Mujoco},
      {"bullet", EngineRules::Bullet},
      {"gazebo", EngineRules::Gazebo},
      {"trivet", EngineRules::Trivet}};
  return out;
}

}  // namespace

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

std::optional<EngineRules> rules_of(const std::string& name) {
  for (const auto& [known, rules] : rules_by_name())
    if (known == name) return rules;
  return std::nullopt;
}

std::vector<std::string> rules_names() {
  std::vector<std::string> out;
  for (const auto& [name, rules] : rules_by_name()) out.push_back(name);
  return out;
}

void apply_rules(EngineRules rules, ForeignScene& scene) {
  if (rules == EngineRules::OfFormat) return;
  scene.friction_rule = rules == EngineRules::Mujoco   ? FrictionRule::Larger
                        : rules == EngineRules::Bullet ? FrictionRule::Product
                                                       : FrictionRule::Smaller;
  if (rules == EngineRules::Mujoco) return;
  for (ForeignBody& body : scene.bodies)
    for (ForeignCollider& collider : body.colliders) collider.bits.priority = 0;
}

void count_faces(const Mesh& mesh, ForeignScene& scene) {
  scene.num_faces += mesh.triangles.size();
  if (scene.num_faces > kMostFaces)
    bad_file(scene.files.at(0).path, "has too many faces that collide; accepted: %1", kMostFaces);
}

void refine_balls(ForeignScene& scene) {
  std::vector<ForeignCollider*> balls;
  for (ForeignBody& body : scene.bodies)
    for (ForeignCollider& collider : body.colliders)
      if (collider.ball_radius > 0) balls.push_back(&collider);
  if (balls.empty()) return;
  // A ball of n sides has about n * n faces.
  const double sides = std::sqrt(kMostBallFaces / static_cast<double>(balls.size()));
  const int whole = std::clamp(static_cast<int>(sides) / 4 * 4, kFewestBallSides, kMostBallSides);
  if (whole == kFewestBallSides) return;
  std::map<double, std::shared_ptr<const Mesh>> by_radius;
  for (ForeignCollider* const ball : balls) {
    auto& mesh = by_radius[ball->ball_radius];
    if (!mesh) mesh = std::make_shared<const Mesh>(ball_mesh(ball->ball_radius, whole));
    ball->mesh = mesh;
  }
}

}  // namespace trivet
