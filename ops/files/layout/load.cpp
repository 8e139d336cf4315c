#include "ops/files/layout/load.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "core/base/arena.h"
#include "core/io/process/sandboxed_import.h"
#include "core/scene/collision_mesh.h"
#include "ops/files/foreign/articulation.h"

namespace trivet {
namespace {

LoadedModel load_model(const ModelRequest& request, const ModelSource& source) {
  Model model = source(request.name, request.tessellation);
  model.path = request.name;
  model.tessellation = request.tessellation;
  auto shape = make_shape(model.mesh);
  return {std::make_shared<const Model>(std::move(model)), std::move(shape)};
}

}  // namespace

ModelSource models_in_folder(const std::string& folder, const ImportLimits& limits) {
  return [folder, limits](const std::string& name, const Tessellation& tessellation) {
    const std::string path = (std::filesystem::path(folder) / name).string();
    if (is_link_model(path)) return link_model(path, limits);
    return import_model(path, limits, tessellation);
  };
}

std::vector<LoadedModel> load_models(const std::vector<ModelRequest>& requests,
                                     const ModelSource& source, int num_threads,
                                     const ProgressCallback& progress) {
  std::vector<LoadedModel> loaded(requests.size());
  std::vector<std::exception_ptr> errors(requests.size());
  std::atomic<size_t> next = 0;
  std::atomic<bool> failed = false;
  std::mutex mutex;
  size_t num_done = 0;
  const auto work = [&] {
    std::optional<SharedImporters> importers;
    if (requests.size() > 1) importers.emplace();
    // Requests are taken in order, and what is begun is finished: the first error is always found.
    for (size_t i; !failed && (i = next++) < requests.size();) {
      try {
        loaded[i] = load_model(requests[i], source);
        const std::lock_guard lock(mutex);
        if (progress) progress({"load", requests[i].name, ++num_done, requests.size()});
      } catch (...) {
        errors[i] = std::current_exception();
        failed = true;
      }
    }
  };

  const size_t num_cores = std::max(1u, std::thread::hardware_concurrency());
  const size_t num_workers =
      std::min(requests.size(), num_threads > 0 ? static_cast<size_t>(num_threads) : num_cores);
  std::vector<std::jthread> helpers;
  for (size_t k = 1; k < num_workers; ++k) helpers.emplace_back([&] { in_arena(0, work); });
  work();
  helpers.clear();
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
  return loaded;
}

void load_model(const Scene& scene, const ModelSource& models, AppendOperation& operation) {
  if (operation.shape) return;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (object.given_mass || has_collision_mesh(object) || object.model->path != operation.model ||
        object.model->tessellation != operation.tessellation)
      continue;
    operation.model_data = object.model;
    operation.shape = object.shape;
    return;
  }
  if (!models) return;
  const LoadedModel loaded =
      load_models({{operation.model, operation.tessellation}}, models, 1, {}).front();
  operation.model_data = loaded.model;
  operation.shape = loaded.shape;
}

}  // namespace trivet
