#include <algorithm>
#include <filesystem>
#include <map>

#include "apps/farm/batch/batch.h"
#include "apps/farm/recipe/views.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;

/// Models and environments.
std::vector<std::string> files_of(const std::string& text, const std::string& file) {
  std::vector<std::string> out = models_of(parse_recipe(text, file));
  nlohmann::json document = nlohmann::json::parse(text);
  if (document.contains("views"))
    rename_environments(document["views"], [&](const std::string& name) {
      if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
      return name;
    });
  return out;
}

PreparedRecipe with_models(const std::string& text, const std::string& file,
                           const std::function<BatchModel(const std::string&)>& model_of) {
  std::map<std::string, std::string> stored;
  PreparedRecipe out;
  for (const std::string& name : files_of(text, file)) {
    out.models.push_back(model_of(name));
    stored[name] = out.models.back().stored_path();
  }
  out.canonical =
      canonical_recipe(text, file, [&](const std::string& name) { return stored.at(name); });
  out.recipe = parse_recipe(out.canonical, file);
  return out;
}

}  // namespace

PreparedRecipe prepare_recipe(const std::string& text, const std::string& file,
                              const std::string& folder) {
  return with_models(text, file, [&](const std::string& name) {
    return batch_model((fs::path(folder) / name).string());
  });
}

PreparedRecipe prepared_recipe(const BatchRun& run, const std::string& out) {
  return with_models(run.recipe, out + "/run.json", [&](const std::string& name) {
    const fs::path stored(name);
    return BatchModel{(fs::path(out) / stored).string(),
                      stored.filename().string(),
                      {},
                      stored.parent_path().filename().string(),
                      "models/"};
  });
}

Work work_of(const PreparedRecipe& prepared, const BatchRun& run, const ImportLimits& import,
             const std::string& out, bool stored) {
  Work work;
  work.recipe = prepared.recipe;
  work.key = recipe_key(prepared.canonical, run.seed);
  for (const BatchModel& model : prepared.models)
    work.file_of[model.stored_path()] =
        stored ? (fs::path(out) / model.stored_path()).string() : model.file;
  work.import = import;
  work.with_scene = run.with_scene;
  work.with_contacts = run.with_contacts;
  work.with_report = run.with_report;
  work.version = run.version;
  return work;
}

}  // namespace trivet::farm
