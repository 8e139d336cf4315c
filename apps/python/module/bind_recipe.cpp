// Random scenes of a recipe, made in this process: those of `trivet batch`.
#include <pybind11/stl.h>

#include "apps/farm/batch/batch.h"
#include "apps/farm/scene/make_scene.h"
#include "apps/farm/scene/scene_json.h"
#include "apps/python/module/bindings.h"
#include "apps/python/module/made_by_functions.h"

namespace trivet::python {
namespace {

using namespace py::literals;

ImportLimits recipe_limits(const std::string& importer) {
  ImportLimits limits;
  limits.importer = importer;
  return limits;
}

/// A recipe with its models, read once.
class RecipeSource {
 public:
  RecipeSource(const std::string& text, const std::string& name, std::string folder,
               std::uint64_t seed, const std::string& importer)
      : m_folder(std::move(folder)), m_limits(recipe_limits(importer)) {
    const farm::PreparedRecipe prepared = farm::prepare_recipe(text, name, m_folder);
    farm::BatchRun run;
    run.seed = seed;
    run.version = TRIVET_VERSION;
    m_work = farm::work_of(prepared, run, m_limits, "", false);
    m_models = farm::load_models(m_work);
  }

  farm::MadeScene make(std::uint64_t k, const RunContext& context) const {
    return farm::make_scene({m_work.recipe, m_models, m_work.key, context}, k);
  }
  OpenedSession opened(farm::MadeScene made) const {
    const SettleRules rules = rules_of(made.run.settle);
    made.layout.settle = rules;
    const double clearance = made.run.settle.clearance;
    Session session(std::move(made.run.scene), std::move(made.layout),
                    models_in_folder(m_folder, m_limits));
    return {std::move(session), "", m_folder, clearance, {}, rules};
  }

 private:
  std::string m_folder;
  ImportLimits m_limits;
  farm::Work m_work;
  LoadedModels m_models;
};

std::shared_ptr<RecipeSource> recipe_of(const std::string& text, const std::string& name,
                                        const std::string& folder, std::uint64_t seed,
                                        const std::string& importer) {
  return without_gil(
      [&] { return std::make_shared<RecipeSource>(text, name, folder, seed, importer); });
}

std::shared_ptr<SharedScene> shared_of(OpenedSession opened, const SettleOptions& settle) {
  auto out = std::make_shared<SharedScene>(std::move(opened));
  out->settle = settle;
  return out;
}

// The scene, and its JSON as in a batch; no scene: it took too long.
py::tuple made_scene(const RecipeSource& recipe, std::uint64_t k, double budget_s) {
  std::atomic<bool> cancel = false;
  const Cancellable cancellable(cancel);
  RunContext context;
  context.cancel = &cancel;
  context.time_budget_s = budget_s;
  farm::MadeScene made = without_gil([&] { return recipe.make(k, context); });
  if (PyErr_CheckSignals()) throw py::error_already_set();
  if (made.end == OperationResult::Status::Cancelled) raise_stopped();
  if (made.end == OperationResult::Status::OutOfTime) return py::make_tuple(py::none(), "");
  std::string json = farm::json_line(farm::scene_json(k, made));
  const SettleOptions settle = made.run.settle;
  return py::make_tuple(shared_of(recipe.opened(std::move(made)), settle), std::move(json));
}

}  // namespace

void bind_recipe(py::module_& m) {
  py::class_<RecipeSource, std::shared_ptr<RecipeSource>>(m, "Recipe", made_by_functions())
      .def_static("read", &recipe_of, "text"_a, "name"_a, "folder"_a, "seed"_a, "importer"_a)
      .def("scene", &made_scene, "k"_a, "budget"_a);
}

}  // namespace trivet::python
