#include "ops/files/report/models_of_shapes.h"

#include <algorithm>
#include <map>

#include "core/io/mesh_model.h"
#include "core/scene/transaction.h"

namespace trivet {

WholeModels::WholeModels(const Scene& scene) : m_given(scene) {
  std::vector<ObjectId> bare = scene.ids();
  std::erase_if(bare, [&](ObjectId id) { return scene.at(id).model != nullptr; });
  if (bare.empty()) return;
  m_copy = scene;
  std::map<const Shape*, std::shared_ptr<const Model>> models;
  Transaction transaction(*m_copy);
  for (const ObjectId id : bare) {
    const Shape& shape = *scene.at(id).shape;
    std::shared_ptr<const Model>& model = models[&shape];
    if (!model) model = std::make_shared<const Model>(model_of_mesh(shape.mesh));
    transaction.edit(id, [&](Object& object) { object.model = model; });
  }
  transaction.commit();
}

}  // namespace trivet
