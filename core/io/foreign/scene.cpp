#include "core/io/foreign/scene.h"

#include <algorithm>

#include "core/base/bad_input.h"

namespace trivet {
namespace {

constexpr size_t kMostNotes = 100, kMostFaces = 8'000'000;

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

}  // namespace trivet
