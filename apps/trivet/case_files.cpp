#include "apps/trivet/case_files.h"

#include <filesystem>
#include <set>

#include "apps/farm/recipe/recipe.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/io/opened_files.h"
#include "core/io/process/sandboxed_import.h"
#include "ops/files/arrange/problem.h"
#include "ops/files/json/text.h"
#include "ops/files/layout/paths.h"
#include "ops/files/report/scene_file.h"
#include "ops/session/journal.h"

namespace trivet::apps {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

Paths in_folder(const std::string& folder, Paths names) {
  for (std::string& name : names) name = (fs::path(folder) / name).string();
  return names;
}

Paths named_by_json(const std::string& file, const std::string& text) {
  const nlohmann::json json = parse_json(text, file);
  if (json.contains("trivet_recipe"))
    return in_folder(folder_of(file), farm::models_of(farm::parse_recipe(text, file)));
  const bool problem = json.contains("arrange");
  return model_files(problem ? parse_problem(text, file).layout : parse_layout(text, file),
                     folder_of(file));
}

Paths named_by_journal(const std::string& file) {
  const JournalContent content = read_journal(file);
  Paths out{(fs::path(folder_of(file)) / content.start.file).string(), start_copy_of(file)};
  const std::string folder = folder_of(out.front());
  const auto add = [&](const RecordedModels& models) {
    for (const RecordedModel& model : models)
      out.push_back((fs::path(folder) / model.request.name).string());
  };
  add(content.start.models);
  for (const JournalRecord& record : content.records) add(record.models);
  return out;
}

Paths named_by_scene(const std::string& file, const ImportLimits& limits) {
  return model_files(read_scene_file(file, limits).layout, folder_of(file));
}

Paths named_by_model(const std::string& file, const ImportLimits& limits) {
  import_model(file, limits);
  return files_opened_for(file).value_or(Paths{});
}

// Calls each reader that may know the file; what it cannot read names nothing.
Paths named_by(const std::string& file, const ImportLimits& limits) {
  const std::string extension = lower_extension(file);
  Paths out;
  const auto add = [&](const auto& read) {
    try {
      for (std::string& name : read()) out.push_back(std::move(name));
    } catch (const Error&) {
    }
  };
  if (extension == ".json")
    add([&] { return named_by_json(file, read_text_file(file, limits.max_file_bytes)); });
  else
    add([&] { return named_by_journal(file); });
  if (out.empty()) add([&] { return named_by_model(file, limits); });
  if (extension == ".glb" || extension == ".gltf")
    add([&] { return named_by_scene(file, limits); });
  return out;
}

}  // namespace

std::vector<std::string> files_of_case(const std::vector<std::string>& files,
                                       const ImportLimits& limits) {
  std::set<std::string> found;
  Paths waiting = files;
  while (!waiting.empty()) {
    std::error_code error;
    const fs::path path = fs::canonical(waiting.back(), error);
    waiting.pop_back();
    if (error || !fs::is_regular_file(path, error) || !found.insert(path.string()).second) continue;
    for (std::string& name : named_by(path.string(), limits)) waiting.push_back(std::move(name));
  }
  return {found.begin(), found.end()};
}

}  // namespace trivet::apps
