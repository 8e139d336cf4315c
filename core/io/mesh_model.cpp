#include "core/io/mesh_model.h"

#include "core/base/error.h"

namespace trivet {

Model model_of_mesh(Mesh mesh) {
  if (mesh.triangles.empty())
    throw Error(Error::Kind::BadInput, "a mesh without triangles; accepted: one at least");
  Model model;
  model.format = "arrays";
  model.materials.emplace_back();
  model.face_material.assign(mesh.triangles.size(), 0);
  model.num_nodes = 1;
  model.mesh = std::move(mesh);
  return model;
}

}  // namespace trivet
