#include "apps/serve/scenes.h"

#include "apps/farm/batch/batch.h"
#include "apps/farm/recipe/sha256.h"
#include "apps/farm/scene/make_scene.h"
#include "ops/files/json/input_text.h"
#include "ops/files/json/text.h"
#include "ops/files/layout/paths.h"

namespace trivet::serve {

RecipeScenes::RecipeScenes(const std::string& recipe, std::uint64_t seed,
                           const ImportLimits& import, const std::string& version,
                           double scene_seconds)
    : m_file(recipe), m_folder(folder_of(recipe)), m_seed(seed), m_scene_seconds(scene_seconds) {
  const std::string text = read_input_text(recipe, import.max_file_bytes, TextKind::Json);
  const farm::PreparedRecipe prepared = farm::prepare_recipe(text, recipe, m_folder);
  m_hash = farm::sha256_hex(prepared.canonical);
  farm::BatchRun run;
  run.seed = seed;
  run.version = version;
  run.with_scene = true;
  m_work = farm::work_of(prepared, run, import, "", false);
  m_models = farm::load_models(m_work);
}

farm::MadeScene RecipeScenes::make(std::uint64_t k) const {
  farm::SceneSource source{m_work.recipe, m_models, m_work.key};
  source.context.cancel = &m_ended;
  source.context.time_budget_s = m_scene_seconds;
  farm::MadeScene out = farm::make_scene(source, k);
  const std::string scene = "scene " + std::to_string(k);
  if (out.end == OperationResult::Status::Cancelled)
    throw NoScene(true, scene + " was cancelled: the server ends");
  if (out.end == OperationResult::Status::OutOfTime)
    throw NoScene(false, scene + " did not end within " + short_number(m_scene_seconds) + " s");
  return out;
}

std::string RecipeScenes::json(std::uint64_t k) const {
  return farm::json_line(farm::scene_json(k, make(k)));
}

std::string RecipeScenes::glb(std::uint64_t k) const {
  return std::move(farm::members_of(m_work, k, make(k)).more.front().bytes);
}

OpenedSession RecipeScenes::open(std::uint64_t k) const {
  farm::MadeScene made = make(k);
  const SettleRules rules = rules_of(made.run.settle);
  made.layout.settle = rules;
  return {Session(std::move(made.run.scene), std::move(made.layout),
                  models_in_folder(m_folder, m_work.import)),
          m_file,
          m_folder,
          made.run.settle.clearance,
          {},
          rules};
}

}  // namespace trivet::serve
