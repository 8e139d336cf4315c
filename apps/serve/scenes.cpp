#include "apps/serve/scenes.h"

#include "apps/farm/batch/batch.h"
#include "apps/farm/recipe/sha256.h"
#include "apps/farm/scene/make_scene.h"
#include "ops/files/json/input_text.h"
#include "ops/files/layout/paths.h"

namespace trivet::serve {

RecipeScenes::RecipeScenes(const std::string& recipe, std::uint64_t seed,
                           const ImportLimits& import, const std::string& version)
    : m_file(recipe), m_folder(folder_of(recipe)), m_seed(seed) {
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

std::string RecipeScenes::json(std::uint64_t k) const {
  const farm::MadeScene made = farm::make_scene({m_work.recipe, m_models, m_work.key}, k);
  return farm::json_line(farm::scene_json(k, made));
}

std::string RecipeScenes::glb(std::uint64_t k) const {
  return std::move(farm::make_members(m_work, m_models, k).more.front().bytes);
}

OpenedSession RecipeScenes::open(std::uint64_t k) const {
  farm::MadeScene made = farm::make_scene({m_work.recipe, m_models, m_work.key}, k);
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
