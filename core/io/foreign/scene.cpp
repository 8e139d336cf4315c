#include "core/io/foreign/scene.h"

#include <algorithm>

#include "core/base/bad_input.h"

namespace trivet {
namespace {

constexpr size_t kMostNotes = 100, kMostFaces = 8'000'000;

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

void count_faces(const Mesh& mesh, ForeignScene& scene) {
  scene.num_faces += mesh.triangles.size();
  if (scene.num_faces > kMostFaces)
    bad_file(scene.files.at(0).path, "has too many faces that collide; accepted: %1", kMostFaces);
}

}  // namespace trivet
