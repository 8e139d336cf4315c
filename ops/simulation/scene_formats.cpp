#include "ops/simulation/scene_formats.h"

#include <algorithm>

#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/io/simulators/simulator_formats.h"
#include "ops/files/report/tables.h"
#include "ops/simulation/simulation.h"

namespace trivet {

const std::vector<SceneFormat>& scene_formats() {
  static const std::vector<SceneFormat> formats = [] {
    using Kind = SceneFormat::Kind;
    std::vector<SceneFormat> out = {{Kind::Scene, "glTF", {".glb", ".gltf"}},
                                    {Kind::Scene, "Wavefront OBJ", {".obj"}},
                                    {Kind::Scene, "PLY", {".ply"}},
                                    {Kind::Scene, "STL", {".stl"}}};
    for (const SimulatorFormat& format : simulator_formats())
      out.push_back({Kind::Simulator, format.name, format.extensions});
    out.push_back({Kind::Table, "CSV", {".csv"}});
    out.push_back({Kind::Table, "JSON lines", {".jsonl"}});
    out.push_back({Kind::Table, "NumPy", {".npy"}});
    return out;
  }();
  return formats;
}

std::vector<std::string> extensions_of(std::initializer_list<SceneFormat::Kind> kinds) {
  std::vector<std::string> out;
  for (const SceneFormat& format : scene_formats())
    if (std::find(kinds.begin(), kinds.end(), format.kind) != kinds.end())
      out.insert(out.end(), format.extensions.begin(), format.extensions.end());
  return out;
}

const SceneFormat* format_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  for (const SceneFormat& format : scene_formats())
    for (const std::string& known : format.extensions)
      if (known == extension) return &format;
  return nullptr;
}

void write_in_any_format(const Scene& scene, const Layout& layout, const SceneFileOptions& options,
                         const std::string& path) {
  const SceneFormat* const format = format_of(path);
  if (!format) {
    std::string accepted;
    for (const SceneFormat& known : scene_formats())
      for (const std::string& extension : known.extensions)
        accepted.append(accepted.empty() ? "" : ", ").append(extension);
    bad_input("%1: has no extension of a format; accepted: %2", path, accepted);
  }
  switch (format->kind) {
    case SceneFormat::Kind::Scene:
      return write_scene_file(scene, layout, options, path);
    case SceneFormat::Kind::Simulator:
      export_simulation(scene, path);
      return;
    case SceneFormat::Kind::Table:
      return write_table(scene, Table::Poses, path);
  }
}

}  // namespace trivet
