#include "apps/python/module/drawn_looks.h"

namespace trivet::python {

void DrawnLooks::share(LabelledScene& scene, const Scene& of) {
  const std::lock_guard lock(m_mutex);
  std::map<const Model*, Known> now;
  for (const ObjectId id : of.ids()) {
    const std::shared_ptr<const Model>& model = of.at(id).model;
    const auto mesh = scene.meshes.find(model.get());
    if (mesh == scene.meshes.end()) continue;
    if (const auto known = m_known.find(model.get()); known != m_known.end())
      mesh->second.look = known->second.look;
    now.try_emplace(model.get(), Known{model, mesh->second.look});
  }
  m_known = std::move(now);
}

}  // namespace trivet::python
