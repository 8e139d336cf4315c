// Models for many objects: each read once, with its shape, on several threads.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/index/shape.h"
#include "core/io/read_model.h"
#include "core/model/model.h"
#include "core/scene/scene.h"
#include "ops/operations/operations.h"

namespace trivet {

/// Progress of long work, for display.
struct Progress {
  std::string stage;  // "load", "stand", "put", "check"
  std::string item;   // a model or an object
  size_t done = 0, total = 0;
};
using ProgressCallback = std::function<void(const Progress&)>;

/// Gives the model of that name, or throws an Error. Called from several threads at a time.
using ModelSource = std::function<Model(const std::string& name, const Tessellation& tessellation)>;

/// Models from files, with paths relative to `folder`.
ModelSource models_in_folder(const std::string& folder, const ImportLimits& limits = {});

/// Cache key: equal requests share a model.
struct ModelRequest {
  std::string name;
  Tessellation tessellation = {};

  friend auto operator<=>(const ModelRequest&, const ModelRequest&) = default;
};

struct LoadedModel {
  std::shared_ptr<const Model> model;  // its path is the name it was asked for by
  std::shared_ptr<const Shape> shape;
};

/// Loads these models and makes their shapes. The result does not depend on the number of threads;
/// of several errors the one of the first request is thrown.
/// @param num_threads  0: all cores.
/// @param progress  may be empty; called from one thread at a time.
std::vector<LoadedModel> load_models(const std::vector<ModelRequest>& requests,
                                     const ModelSource& source, int num_threads,
                                     const ProgressCallback& progress);

/// Fills operation.model_data and operation.shape: from an object of the scene that has the same
/// model, else from `models`. @throws what `models` throws.
void load_model(const Scene& scene, const ModelSource& models, AppendOperation& operation);

}  // namespace trivet
