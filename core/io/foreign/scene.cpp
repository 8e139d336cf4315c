#include "core/io/foreign/scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/bad_input.h"

namespace trivet {
namespace {

constexpr size_t kMostNotes = 100, kMostFaces = 8'000'000;
constexpr double kMostRoundFaces = 2e6;  // of round shapes that are made finer

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

void refine_round_shapes(ForeignScene& scene) {
  std::vector<ForeignCollider*> round;
  for (ForeignBody& body : scene.bodies)
    for (ForeignCollider& collider : body.colliders)
      if (collider.round && (!body.fixed || collider.round->half == 0)) round.push_back(&collider);
  if (round.empty()) return;
  // A shape of n sides has n * n / 2 faces.
  const double sides = std::sqrt(2 * kMostRoundFaces / static_cast<double>(round.size()));
  const int whole = std::clamp(static_cast<int>(sides) / 4 * 4, kFewestBallSides, kMostBallSides);
  if (whole == kFewestBallSides) return;
  std::vector<const ForeignCollider*> different;
  for (ForeignCollider* const collider : round) {
    const auto like = std::find_if(different.begin(), different.end(), [&](const auto* known) {
      return known->round == collider->round;
    });
    if (like == different.end())
      collider->mesh = std::make_shared<const Mesh>(round_mesh(*collider->round, whole));
    else
      collider->mesh = (*like)->mesh;
    if (like == different.end()) different.push_back(collider);
  }
}

}  // namespace trivet
