#include "ops/session/recorded_sources.h"

#include <filesystem>

#include "core/base/error.h"
#include "core/io/mesh_model.h"
#include "core/io/model_bytes.h"
#include "core/mesh/weld_arrays.h"
#include "ops/files/json/text.h"
#include "ops/files/report/geometry.h"
#include "ops/session/journal.h"

namespace trivet {
namespace {

// Corner i has the upper bound of axis k where bit k of i is set.
Model box_model(const RecordedModel& of) {
  constexpr int kSides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    Vec3 corner;
    for (int k = 0; k < 3; ++k) corner[k] = (i >> k & 1 ? of.box.upper : of.box.lower)[k];
    corners.push_back(corner);
  }
  std::vector<Index3> triangles;
  for (const auto& s : kSides) {
    triangles.push_back({s[0], s[1], s[2]});
    triangles.push_back({s[0], s[2], s[3]});
  }
  Model model = model_of_mesh(weld(corners, triangles).mesh);
  model.up = of.up;
  return model;
}

}  // namespace

RecordedSources::RecordedSources(std::string journal, ModelSource files)
    : m_journal(std::move(journal)), m_files(std::move(files)) {}

void RecordedSources::expect(const RecordedModels& models) {
  const std::lock_guard lock(m_mutex);
  for (const RecordedModel& model : models) m_expected[model.request] = model;
}

void RecordedSources::end() {
  const std::lock_guard lock(m_mutex);
  m_expected.clear();
}

void RecordedSources::note(const ModelRequest& request, const Sentence& what) {
  const std::lock_guard lock(m_mutex);
  m_notes[request] = say("\"%1\" %2", request.name, what);
}

// Untrusted like the model's own file.
std::optional<Model> RecordedSources::kept(const RecordedModel& wanted) const {
  const std::string file = kept_model_of(m_journal, wanted.fingerprint);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
  try {
    const ImportLimits limits;
    Model model = model_from_bytes(read_text_file(file, limits.max_file_bytes), file, limits);
    if (geometry_fingerprint(model.mesh) == wanted.fingerprint) return model;
  } catch (const Error&) {
  }
  return std::nullopt;
}

Model RecordedSources::model(const std::string& name, const Tessellation& tessellation) {
  const ModelRequest request{name, tessellation};
  std::optional<RecordedModel> wanted;
  {
    const std::lock_guard lock(m_mutex);
    if (const auto found = m_expected.find(request); found != m_expected.end())
      wanted = found->second;
  }
  if (!wanted) return from_file(request);
  std::optional<Model> now;
  Sentence why;
  try {
    now = from_file(request);
    if (geometry_fingerprint(now->mesh) == wanted->fingerprint) return std::move(*now);
  } catch (const Error& e) {
    why = e.sentence();
  }
  if (auto model = kept(*wanted)) return std::move(*model);
  if (now) {
    note(request, "has changed since the session");
    return std::move(*now);
  }
  note(request, say("cannot be read, and a box of its size stands in for it: %1", why));
  return box_model(*wanted);
}

std::vector<Sentence> RecordedSources::notes() const {
  const std::lock_guard lock(m_mutex);
  std::vector<Sentence> out;
  for (const auto& [request, what] : m_notes) out.push_back(what);
  return out;
}

}  // namespace trivet
