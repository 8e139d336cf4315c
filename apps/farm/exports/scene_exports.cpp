#include "apps/farm/exports/scene_exports.h"

#include <algorithm>
#include <filesystem>
#include <functional>

#include "apps/farm/scene/standing.h"
#include "apps/farm/store/publish.h"
#include "core/base/arena.h"
#include "core/base/error.h"
#include "core/io/simulators/simulator_formats.h"
#include "ops/check/check.h"
#include "ops/files/json/text.h"
#include "ops/files/report/scene_file.h"
#include "ops/simulation/simulation.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const std::string& kind) {
  for (const SimulatorFormat& format : simulator_formats())
    if (format.kind == kind) return format.extensions.front();
  return ".glb";
}

/// A folder as deep below OUT as those of units, so that relative paths are the same.
class Workshop {
 public:
  explicit Workshop(const std::string& out)
      : m_root(temporary_name((fs::path(out) / "exports").string())) {
    make_folders(file(""));
  }
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(m_root, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  std::string file(const std::string& name) const {
    return (fs::path(m_root) / "scenes" / name).string();
  }

 private:
  std::string m_root;
};

/// Steps, one after the other, where convex parts of two objects overlap: hulls a little
/// smaller, then overlaps that a simulator pushes apart by as much.
struct Leniency {
  double hull_clearance = 0, max_overlap = 0;  // metres
};
constexpr Leniency kLeniencies[] = {{0, 0}, {1e-4, 0}, {3e-4, 3e-4}, {1e-3, 1e-3}};

class SceneExporter {
 public:
  SceneExporter(const ExportWork& work, const Scene& scene, std::uint64_t k)
      : m_scene(scene), m_k(k), m_workshop(work.out) {
    m_options.files.mesh_folder = "../../meshes";
    m_options.files.for_many_scenes = true;
    m_options.cache = work.parts;
  }

  Member write(const std::string& kind, Json& told) {
    const std::string name = member_name(m_k, ending_of(kind));
    const std::string path = m_workshop.file(name);
    if (!m_parts) m_parts = simulation_of(m_scene, member_name(m_k, ""), m_options);
    if (std::none_of(m_parts->overlaps.begin(), m_parts->overlaps.end(), is_too_deep)) {
      SimulationScene scene = m_parts->scene;  // with the names of the kind
      write_simulation(scene, path, m_options.files);
    } else {
      write_leniently(path, kind, told);
    }
    return {name, read_text_file(path, std::uintmax_t{1} << 32)};
  }

 private:
  static bool is_too_deep(const PartOverlap& overlap) { return overlap.depth > overlap.allowed; }

  void write_leniently(const std::string& path, const std::string& kind, Json& told) const {
    for (const Leniency& leniency : kLeniencies) {
      SimulationOptions options = m_options;
      options.hull_clearance = leniency.hull_clearance;
      options.max_overlap = leniency.max_overlap;
      try {
        export_simulation(m_scene, path, options);
      } catch (const Error& error) {
        const bool last = &leniency == std::end(kLeniencies) - 1;
        if (error.kind() != Error::Kind::BadInput || last) throw;
        continue;
      }
      if (leniency.hull_clearance > 0)
        told[kind] = {{"hull_clearance", leniency.hull_clearance},
                      {"max_overlap", leniency.max_overlap}};
      return;
    }
  }

  const Scene& m_scene;
  std::uint64_t m_k;
  Workshop m_workshop;
  SimulationOptions m_options;
  std::optional<SimulationExport> m_parts;
};

// As it is where the name is not that of a folder that is gone.
std::string reason_of(const std::string& kind, const Error& error) {
  std::string text = error.what();
  if (const size_t at = text.find(": "); text.rfind('/', at) != std::string::npos)
    text.erase(0, at + 2);
  return kind + ": " + text;
}

void write_all(const ExportWork& work, const Scene& scene, const Layout& layout, std::uint64_t k,
               SceneMembers& out) {
  Json& told = out.scene["exports"] = Json::object();
  SceneExporter exporter(work, scene, k);
  for (const std::string& kind : work.kinds) {
    try {
      out.more.push_back(kind == "glb"
                             ? Member{member_name(k, ".glb"),
                                      scene_file_bytes(scene, layout, {work.version, "", 0})}
                             : exporter.write(kind, told));
    } catch (const Error& error) {
      if (error.kind() != Error::Kind::BadInput) throw;
      out.scene["status"] = "refused";
      out.scene["reason"] = reason_of(kind, error);
      out.more.clear();
      return;
    }
  }
}

}  // namespace

const std::vector<std::string>& export_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> out;
    for (const SimulatorFormat& format : simulator_formats()) out.push_back(format.kind);
    out.emplace_back("glb");
    return out;
  }();
  return kinds;
}

SceneMembers make_exports(const ExportWork& work, SceneReader& scenes, const Recipe& recipe,
                          const LoadedModels& models, std::uint64_t k) {
  SceneMembers out{scenes.read(k / work.scenes.per_unit, k), {}};
  if (out.scene.value("status", Json()) != "ok") return out;
  const std::string where = "scene " + std::to_string(k);
  const Layout layout = layout_of_poses(recipe, out.scene, where);
  Scene scene = standing(layout, models, where);
  const auto write = [&] {
    update_contacts(scene, 0, with_rules({}, recipe.base.settle));
    write_all(work, scene, layout, k, out);
  };
  in_arena(1, write);
  std::sort(out.more.begin(), out.more.end(),
            [](const Member& a, const Member& b) { return a.name < b.name; });
  return out;
}

}  // namespace trivet::farm
