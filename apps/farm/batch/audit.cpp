#include "apps/farm/batch/audit.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "apps/farm/store/damage.h"
#include "apps/farm/store/publish.h"
#include "core/base/bad_input.h"
#include "core/io/atomic_file.h"
#include "core/io/read_model.h"
#include "ops/files/layout/paths.h"
#include "ops/files/report/scene_file.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;
using FileTime = fs::file_time_type;

std::vector<std::uint64_t> units_there(const std::string& out, const BatchRun& run) {
  std::vector<std::uint64_t> units;
  for (std::uint64_t t = 0; t < run.num_units(); ++t)
    if (unit_exists(out, t, run.format)) units.push_back(t);
  return units;
}

/// Calls visit(path) for temporary files and folders of units and models.
template <class Visitor>
void visit_temporaries(const std::string& out, const Visitor& visit) {
  std::error_code ignored;
  const auto look_in = [&](const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder, ignored))
      if (is_temporary(entry.path().filename().string())) visit(entry.path());
  };
  look_in(out);
  for (const auto& entry : fs::directory_iterator(out, ignored))
    if (entry.is_directory(ignored)) look_in(entry.path());
}

// Temporary files that no process writes and that are a day old, as others may be of processes on
// machines whose locks are not seen here.
void delete_what_was_left(const std::string& out) {
  std::vector<fs::path> left;
  visit_temporaries(out, [&](const fs::path& path) { left.push_back(path); });
  if (left.empty()) return;
  std::error_code ignored;
  try {
    const FileTime now = time_in(out);
    for (const fs::path& path : left)
      if (now - fs::last_write_time(path, ignored) > std::chrono::hours(24) &&
          !is_being_written(path.string()))
        fs::remove_all(path, ignored);
  } catch (const Error&) {
    return;  // who may not write here may not delete either
  }
}

// Scenes of all units but the one that was written first, over the time since.
std::optional<double> rate_of(const std::vector<std::pair<FileTime, std::uint64_t>>& units) {
  if (units.size() < 2) return std::nullopt;
  const auto [first, last] = std::minmax_element(units.begin(), units.end());
  const double seconds = std::chrono::duration<double>(last->first - first->first).count();
  if (!(seconds > 0)) return std::nullopt;
  std::uint64_t scenes = 0;
  for (const auto& [time, count] : units) scenes += count;
  return static_cast<double>(scenes - first->second) / seconds;
}

const char* const kColumns[] = {
    "k",         "status",    "reason", "attempt",      "objects",        "operations", "refused",
    "triangles", "stability", "margin", "smallest_gap", "least_friction", "kilograms"};

std::string csv_field(const Json& row, const char* column) {
  if (!row.contains(column) || row[column].is_null()) return "";
  if (!row[column].is_string()) return row[column].dump();
  std::string out = "\"";
  for (const char c : row[column].get<std::string>()) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string csv_line(const Json& row) {
  std::string out;
  for (const char* const column : kColumns)
    out += (out.empty() ? "" : ",") + csv_field(row, column);
  return out + "\n";
}

std::string csv_head() {
  std::string out;
  for (const char* const column : kColumns) out += (out.empty() ? "" : ",") + std::string(column);
  return out + "\n";
}

}  // namespace

BatchStatus batch_status(const std::string& out) {
  BatchStatus status;
  status.run = read_run(out);
  const std::string batch = status.run.id();
  std::vector<std::pair<FileTime, std::uint64_t>> times;
  for (std::uint64_t unit = 0; unit < status.run.num_units(); ++unit) {
    if (!unit_exists(out, unit, status.run.format)) {
      if (status.first_missing.size() < BatchStatus::kMostMissing)
        status.first_missing.push_back(unit);
      continue;
    }
    ++status.units_there;
    visit_rows(out, unit, status.run.format, batch, [&](const Json& row) {
      const std::string is = row.at("status");
      ++(is == "ok" ? status.ok : is == "refused" ? status.refused : status.failed);
      if (is != "ok") ++status.reasons[is + ": " + row.value("reason", "")];
    });
    times.emplace_back(fs::last_write_time(fs::path(out) / unit_name(unit, status.run.format)),
                       status.run.end_scene(unit) - status.run.first_scene(unit));
  }
  status.scenes_per_second = rate_of(times);
  status.notes = read_notes(out, BatchStatus::kMostNotes);
  visit_temporaries(out, [&](const fs::path&) { ++status.num_temporaries; });
  return status;
}

std::uint64_t merge_manifests(const std::string& out, const std::string& file) {
  const std::string extension = fs::path(file).extension().string();
  if (extension != ".jsonl" && extension != ".csv")
    bad_file(file, "is no kind of manifest; accepted: .jsonl, .csv");
  const BatchRun run = read_run(out);
  const std::string batch = run.id();
  std::uint64_t num_scenes = 0;
  write_file_atomically(file, [&](const ByteSink& write) {
    if (extension == ".csv") write(csv_head());
    for (const std::uint64_t unit : units_there(out, run))
      visit_rows(out, unit, run.format, batch, [&](const Json& row) {
        ++num_scenes;
        write(extension == ".csv" ? csv_line(row) : json_line(row));
      });
  });
  delete_what_was_left(out);
  return num_scenes;
}

void materialise(const std::string& out, std::uint64_t k, const std::string& file,
                 const ImportLimits& import) {
  const BatchRun run = read_run(out);
  if (!run.has_scenes())
    bad_input("%1: there are %2 in this folder; accepted: the batch of their scenes", out,
              run.contents());
  if (k >= run.count) bad_input("scene %1 is not accepted; accepted: 0 to %2", k, run.count - 1);
  const std::uint64_t unit = k / run.per_unit;
  if (!unit_exists(out, unit, run.format))
    bad_file((fs::path(out) / unit_name(unit, run.format)).string(),
             "is not there yet; trivet batch --only makes a scene alone");
  const Json scene = SceneReader(out, run.format).read(unit, k);
  const std::string name = "scene " + std::to_string(k);
  read_undamaged(name, [&] {
    if (scene.at("status") == "failed") bad_input("%1 failed: %2", name, scene.value("reason", ""));
  });
  const PreparedRecipe prepared = prepared_recipe(run, out);
  RunOptions options;
  options.settle.max_motions = prepared.recipe.max_motions;
  options.layout_file = name;
  const Layout layout = layout_of_poses(prepared.recipe, scene, options.layout_file);
  const LayoutRun stands = run_start_only(layout, models_in_folder(out, import), options);
  write_scene_file(stands.scene, layout,
                   {run.version, folder_from(file, out), stands.settle.clearance}, file);
}

}  // namespace trivet::farm
