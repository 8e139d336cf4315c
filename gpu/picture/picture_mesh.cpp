#include "gpu/picture/picture_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/picture/mesh_values.h"
#include "core/picture/picture_normals.h"

namespace trivet {
namespace {

/// A triangle corner as read by the vertex shaders, and by the fragment shader as two texels.
struct Corner {
  float position[3];
  std::int16_t normal[4];       // x 32767; the fourth is padding
  std::int16_t face_normal[4];  // likewise
  std::uint32_t material;
};
static_assert(sizeof(Corner) == 32);

void pack_normal(const Eigen::Vector3f& normal, std::int16_t (&out)[4]) {
  for (int i = 0; i < 3; ++i)
    out[i] = static_cast<std::int16_t>(std::lround(32767 * std::clamp(normal[i], -1.0f, 1.0f)));
  out[3] = 0;
}

bool is_see_through(const PictureMesh& mesh, std::size_t face) {
  return !mesh.materials.empty() &&
         unit_or(mesh.materials[material_of(mesh, face)].base_colour[3], 1) < 1;
}

/// Appends the finite faces that are see-through, or those that are opaque.
void append_corners(const PictureMesh& mesh, bool see_through, const Vec3& centre, double scale,
                    const std::vector<std::array<Eigen::Vector3f, 3>>& normals,
                    std::vector<Corner>& out) {
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    std::array<Vec3, 3> p;
    for (int c = 0; c < 3; ++c) p[c] = (mesh.vertices[mesh.triangles[f][c]] - centre) * scale;
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
    if (is_see_through(mesh, f) != see_through || !normal.allFinite()) continue;
    for (int c = 0; c < 3; ++c) {
      Corner corner;
      for (int i = 0; i < 3; ++i) corner.position[i] = static_cast<float>(p[c][i]);
      pack_normal(normals[f][c], corner.normal);
      pack_normal(normal.cast<float>(), corner.face_normal);
      corner.material = material_of(mesh, f);
      out.push_back(corner);
    }
  }
}

/// Two texels per material: base colour and alpha; roughness and metallic.
std::vector<float> make_material_texels(const PictureMesh& mesh) {
  std::vector<float> texels;
  const Material plain;
  const std::span<const Material> materials =
      mesh.materials.empty() ? std::span(&plain, 1) : mesh.materials;
  for (const Material& m : materials) {
    for (int i = 0; i < 4; ++i) texels.push_back(unit_or(m.base_colour[i], 1.0f));
    for (const float value : {unit_or(m.roughness, 0.6f), unit_or(m.metallic, 0.0f), 0.0f, 0.0f})
      texels.push_back(value);
  }
  return texels;
}

void describe_corners() {
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  constexpr GLsizei stride = sizeof(Corner);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(Corner, position)));
  glVertexAttribPointer(1, 3, GL_SHORT, GL_TRUE, stride, offset(offsetof(Corner, normal)));
  glVertexAttribPointer(2, 3, GL_SHORT, GL_TRUE, stride, offset(offsetof(Corner, face_normal)));
  glVertexAttribIPointer(3, 1, GL_UNSIGNED_INT, stride, offset(offsetof(Corner, material)));
  for (GLuint location = 0; location < 4; ++location) glEnableVertexAttribArray(location);
}

std::array<float, 3> mean_colour(const PictureMesh& mesh) {
  Vec3 sum = Vec3::Zero();
  double weight = 0;
  const Material plain;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Index3& t = mesh.triangles[f];
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double area = (b - a).cross(c - a).norm();
    if (!std::isfinite(area)) continue;
    const std::size_t m = mesh.face_material.empty() ? 0 : mesh.face_material[f];
    const Material& material = m < mesh.materials.size() ? mesh.materials[m] : plain;
    for (int i = 0; i < 3; ++i) sum[i] += area * unit_or(material.base_colour[i], 1.0f);
    weight += area;
  }
  if (!(weight > 0)) return {1, 1, 1};
  const Vec3 mean = sum / weight;
  return {float(mean.x()), float(mean.y()), float(mean.z())};
}

}  // namespace

UploadedMesh upload_mesh(const PictureMesh& mesh) {
  UploadedMesh out;
  out.box = finite_box(mesh);
  if (!out.box.empty()) out.centre = out.box.centre();
  if (const double size = out.box.diagonal(); size > 0) out.scale = 1 / size;
  out.mean_colour = mean_colour(mesh);
  const auto normals = picture_normals(mesh);
  std::vector<Corner> corners;
  append_corners(mesh, false, out.centre, out.scale, normals, corners);
  out.num_opaque = static_cast<GLsizei>(corners.size());
  append_corners(mesh, true, out.centre, out.scale, normals, corners);
  out.num_see_through = static_cast<GLsizei>(corners.size()) - out.num_opaque;
  if (corners.empty()) return out;
  out.vertex_array = GlVertexArray::create();
  glBindVertexArray(out.vertex_array.id());
  out.corners = make_buffer(GL_ARRAY_BUFFER, corners.data(), corners.size() * sizeof(Corner));
  describe_corners();
  const std::vector<float> texels = make_material_texels(mesh);
  out.materials = make_buffer(GL_TEXTURE_BUFFER, texels.data(), texels.size() * sizeof(float));
  out.material_texture = GlTexture::create();
  glBindTexture(GL_TEXTURE_BUFFER, out.material_texture.id());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, out.materials.id());
  out.corner_texture = GlTexture::create();
  glBindTexture(GL_TEXTURE_BUFFER, out.corner_texture.id());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, out.corners.id());
  check_gl("sending materials to the graphics memory");
  return out;
}

MeshPlacement place_mesh(const UploadedMesh& mesh, const Affine& world_from_object,
                         const PictureFrame& frame) {
  MeshPlacement placement;
  placement.frame_from_object.setIdentity();
  placement.frame_from_object.topLeftCorner<3, 3>() =
      (world_from_object.linear * (frame.scale / mesh.scale)).cast<float>();
  placement.frame_from_object.topRightCorner<3, 1>() =
      frame.apply(world_from_object.apply(mesh.centre)).cast<float>();
  placement.frame_from_normal = cofactors(world_from_object.linear).cast<float>();
  return placement;
}

Vec3 box_corner(const Aabb& box, int index) {
  return {index & 1 ? box.upper.x() : box.lower.x(), index & 2 ? box.upper.y() : box.lower.y(),
          index & 4 ? box.upper.z() : box.lower.z()};
}

}  // namespace trivet
