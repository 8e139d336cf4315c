// Scenes, layouts, sessions and exports as files.
#include "apps/library/scene_internal.h"
#include "core/io/overwrites.h"
#include "ops/files/layout/paths.h"
#include "ops/files/report/report.h"
#include "ops/files/report/scene_file.h"
#include "ops/session/kept_layout.h"
#include "ops/simulation/simulation.h"
#include "trivet/export.h"
#include "trivet/layout.h"
#include "trivet/session.h"

namespace trivet::v0 {
namespace {

RunOptions run_options(const std::string& path, const Rules& rules = {}) {
  RunOptions out;
  out.settle.clearance = rules.clearance;
  out.settle.perfect_friction = rules.perfect_friction;
  out.settle.whole_at_rest = rules.whole_at_rest;
  out.settle.robust = rules.robust;
  out.settle.max_motions = rules.max_motions;
  out.layout_file = path;
  return out;
}

ReportOptions report_options(const std::string& folder) {
  ReportOptions out;
  out.version = TRIVET_VERSION;
  out.model_folder = folder;
  return out;
}

Layout layout_in(const Scene& scene) {
  return kept_layout(scene.internal().session(), scene.internal().settle());
}

}  // namespace

Scene open_scene(const std::string& path) {
  return guarded([&] { return scene_of(open_session(path, run_options(path), usual_limits())); });
}

void save_scene(const Scene& scene, const std::string& path) {
  guarded([&] {
    const std::string& folder = scene.internal().opened().model_folder;
    const Layout layout = layout_in(scene);
    check_not_an_input(path, model_files(layout, folder));
    const double asked = scene.rules().clearance;
    const double clearance = asked > 0 ? asked : settled_clearance(scene.internal().opened());
    write_scene_file(scene.internal().scene(), layout,
                     {TRIVET_VERSION, folder_from(path, folder), clearance}, path);
  });
}

Scene open_session(const std::string& path, const std::string& journal) {
  return guarded([&] {
    return scene_of(trivet::open_session(path, run_options(path), usual_limits(), {journal}));
  });
}

Restored restore_session(const std::string& journal) {
  return guarded([&] {
    RestoredSession restored =
        trivet::restore_session(journal, run_options(journal), usual_limits(), false);
    std::vector<std::string> notes = in_english(restored.opened.notes);
    return Restored{scene_of(std::move(restored.opened)), restored.exact, std::move(notes)};
  });
}

LayoutRun run_layout(const std::string& path, const Rules& rules) {
  return guarded([&] {
    const RunOptions options = run_options(path, rules);
    Layout layout = read_layout(path);
    const std::string folder = folder_of(path);
    const ModelSource models = models_in_folder(folder, usual_limits());
    trivet::LayoutRun run = trivet::run_layout(layout, models, options);
    const bool done = run.ok(), stands = run.stability.stable();
    std::string report = report_json(run, report_options(folder));
    layout.settle = rules_of(run.settle);
    const SettleRules kept = layout.settle;
    OpenedSession opened{Session(std::move(run.scene), std::move(layout), models),
                         path,
                         folder,
                         run.settle.clearance,
                         {},
                         kept};
    return LayoutRun{scene_of(std::move(opened), rules), done, stands, std::move(report)};
  });
}

std::string layout_of(const Scene& scene) {
  return guarded([&] { return write_layout(layout_in(scene)); });
}

Export export_scene(const Scene& scene, const std::string& path, const ExportOptions& options) {
  return guarded([&] {
    SimulationOptions inner;
    inner.collision = collision_rule_from_name(options.collision);
    inner.density = options.density;
    inner.friction = options.friction;
    inner.max_overlap = options.max_overlap;
    inner.files.mujoco = options.mujoco;
    check_collision_rule(inner.collision, path);
    const SimulationExport done = export_simulation(scene.internal().scene(), path, inner);
    return Export{done.files, in_english(done.notes)};
  });
}

}  // namespace trivet::v0
