#include "gpu/picture/geometry.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace trivet {

PictureGeometry::PictureGeometry(const PictureScene& scene, const PictureFrame& frame,
                                 PictureStore& store) {
  std::map<const PictureMesh*, std::size_t> known;
  std::size_t texture_bytes = 0;
  for (const PictureObject& object : scene.objects) {
    const auto [entry, is_new] = known.emplace(object.mesh, m_meshes.size());
    if (is_new) {
      m_meshes.push_back(store.mesh(*object.mesh, texture_bytes));
      texture_bytes += m_meshes.back()->texture_bytes();
    }
    const UploadedMesh& mesh = *m_meshes[entry->second];
    if (!mesh.empty()) add_instance(object, entry->second, frame);
  }
}

void PictureGeometry::add_instance(const PictureObject& object, std::size_t mesh,
                                   const PictureFrame& frame) {
  const Affine& pose = object.world_from_object;
  Instance instance;
  instance.mesh = mesh;
  instance.placement = place_mesh(*m_meshes[mesh], pose, frame);
  const auto highlight = object.highlight.value_or(std::array<float, 4>{});
  for (int i = 0; i < 4; ++i)
    instance.highlight[i] =
        std::isfinite(highlight[i]) ? std::clamp(highlight[i], 0.0f, 1.0f) : 0.0f;
  m_instances.push_back(instance);
  for (int i = 0; i < 8; ++i)
    m_hull_points.push_back(frame.apply(pose.apply(box_corner(m_meshes[mesh]->box, i))));
}

bool PictureGeometry::has_textures() const {
  return std::any_of(m_meshes.begin(), m_meshes.end(),
                     [](const auto& mesh) { return mesh->textured(); });
}

bool PictureGeometry::emits() const {
  return std::any_of(m_meshes.begin(), m_meshes.end(),
                     [](const auto& mesh) { return mesh->textured() && mesh->surface->emits(); });
}

void PictureGeometry::draw(const GlProgram& program, const Which& which) const {
  const GLint frame_from_object = program.uniform("frame_from_object");
  const GLint frame_from_normal = program.uniform("frame_from_normal");
  const GLint highlight = program.uniform("highlight");
  const GLint seed = program.uniform("seed");
  const GLint first_triangle = program.uniform("first_triangle");
  const bool finishes = which.textured && *which.textured;
  std::optional<FinishUniforms> uniforms;
  if (finishes) uniforms.emplace(program).set_units();
  for (std::size_t i = 0; i < m_instances.size(); ++i) {
    const Instance& instance = m_instances[i];
    const UploadedMesh& mesh = *m_meshes[instance.mesh];
    if (which.textured && mesh.textured() != *which.textured) continue;
    glUniformMatrix4fv(frame_from_object, 1, GL_FALSE, instance.placement.frame_from_object.data());
    glUniformMatrix3fv(frame_from_normal, 1, GL_FALSE, instance.placement.frame_from_normal.data());
    glUniform4fv(highlight, 1, instance.highlight.data());
    glUniform1ui(seed, static_cast<GLuint>(i));
    bind_texture(1, GL_TEXTURE_BUFFER, mesh.corner_texture.id());
    bind_texture(0, GL_TEXTURE_BUFFER, mesh.material_texture.id());
    glBindVertexArray(mesh.vertex_array.id());
    for (const MeshGroup& group : mesh.groups) {
      if ((group.part == MeshPart::Opaque) != which.solid) continue;
      if (finishes) mesh.surface->bind(*uniforms, group.material);
      glUniform1i(first_triangle, group.first / 3);
      glDrawArrays(GL_TRIANGLES, group.first, group.count);
    }
  }
  if (finishes) SurfaceImages::unbind();
}

}  // namespace trivet
