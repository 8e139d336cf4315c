#include "core/io/appearance.h"

#include <cmath>

namespace trivet {

std::vector<MaterialFaces> faces_by_material(const Model& model) {
  const size_t num_faces = model.mesh.triangles.size();
  const Index num_materials = static_cast<Index>(model.materials.size());
  std::vector<MaterialFaces> groups(std::max<size_t>(1, num_materials));
  for (size_t m = 0; m < groups.size(); ++m) groups[m].material = static_cast<Index>(m);
  for (size_t f = 0; f < num_faces; ++f) {
    const Index id = f < model.face_material.size() ? model.face_material[f] : 0;
    groups[id >= 0 && id < num_materials ? id : 0].faces.push_back(static_cast<Index>(f));
  }
  std::erase_if(groups, [](const MaterialFaces& group) { return group.faces.empty(); });
  return groups;
}

Material material_or_default(const Model& model, Index material) {
  return material < static_cast<Index>(model.materials.size()) ? model.materials[material]
                                                               : Material();
}

CornerNormals shading_normals(const Model& model) {
  if (model.corner_normals.size() != model.mesh.triangles.size()) return smooth_normals(model.mesh);
  CornerNormals normals = model.corner_normals;
  for (auto& face : normals)
    for (Eigen::Vector3f& n : face) {
      const float length = n.norm();
      n = std::isfinite(length) && length > 0 ? Eigen::Vector3f(n / length)
                                              : Eigen::Vector3f(Eigen::Vector3f::Zero());
    }
  fill_missing_normals(model.mesh, normals);
  return normals;
}

}  // namespace trivet
