#include "gpu/picture/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "core/picture/mesh_values.h"
#include "core/picture/normals.h"

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

/// Data of textured meshes beside it.
struct CornerDetail {
  float coordinates[4];     // of both sets
  std::uint16_t colour[4];  // x 65535
  std::int16_t tangent[4];  // x 32767
};
static_assert(sizeof(CornerDetail) == 32);

MeshPart part_of(const DrawnMesh& mesh, std::size_t face) {
  if (mesh.materials.empty()) return MeshPart::Opaque;
  const std::uint32_t material = material_of(mesh, face);
  if (mesh.has_details()) {
    const Transparency transparency = mesh.surface->finishes[material].transparency;
    if (transparency == Transparency::Cut) return MeshPart::Cut;
    if (transparency == Transparency::Blend) return MeshPart::SeeThrough;
  }
  return unit_or(mesh.materials[material].base_colour[3], 1) < 1 ? MeshPart::SeeThrough
                                                                 : MeshPart::Opaque;
}

/// Faces in the order of their groups, those of a group in the mesh's.
std::vector<std::size_t> grouped_faces(const DrawnMesh& mesh) {
  std::vector<std::size_t> faces(mesh.triangles.size());
  std::iota(faces.begin(), faces.end(), std::size_t{0});
  const auto group = [&](std::size_t face) {
    return std::pair(part_of(mesh, face), mesh.has_details() ? material_of(mesh, face) : 0);
  };
  std::stable_sort(faces.begin(), faces.end(),
                   [&](std::size_t a, std::size_t b) { return group(a) < group(b); });
  return faces;
}

std::array<Vec3, 3> scaled_corners(const UploadedMesh& out, const PictureMesh& mesh,
                                   std::size_t face) {
  std::array<Vec3, 3> p;
  for (std::size_t c = 0; c < 3; ++c)
    p[c] =
        (mesh.vertices[static_cast<std::size_t>(mesh.triangles[face][c])] - out.centre) * out.scale;
  return p;
}

CornerDetail detail_of(const SurfaceLook& look, std::size_t face, std::size_t corner) {
  CornerDetail out{};
  for (std::size_t set = 0; set < 2; ++set)
    if (!look.coordinates[set].empty())
      for (int i = 0; i < 2; ++i)
        out.coordinates[2 * set + static_cast<std::size_t>(i)] =
            look.coordinates[set][face][corner][i];
  for (int i = 0; i < 4; ++i) {
    const float colour = look.colours.empty() ? 1 : look.colours[face][corner][i];
    out.colour[i] = static_cast<std::uint16_t>(std::lround(65535 * colour));
    const float along = look.tangents.empty() ? 0 : look.tangents[face][i];
    out.tangent[i] = static_cast<std::int16_t>(std::lround(32767 * std::clamp(along, -1.0f, 1.0f)));
  }
  return out;
}

/// Corners of all finite faces, with the groups that they are drawn in.
struct PackedMesh {
  std::vector<Corner> corners;
  std::vector<CornerDetail> details;
};

PackedMesh pack_mesh(const DrawnMesh& mesh, UploadedMesh& out) {
  const auto normals = picture_normals(mesh);
  PackedMesh packed;
  packed.corners.reserve(3 * mesh.triangles.size());
  for (const std::size_t f : grouped_faces(mesh)) {
    const std::array<Vec3, 3> p = scaled_corners(out, mesh, f);
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
    if (!normal.allFinite()) continue;
    const MeshGroup group{part_of(mesh, f), static_cast<GLint>(packed.corners.size()), 0,
                          mesh.has_details() ? material_of(mesh, f) : 0};
    if (out.groups.empty() || out.groups.back().part != group.part ||
        out.groups.back().material != group.material)
      out.groups.push_back(group);
    out.groups.back().count += 3;
    for (std::size_t c = 0; c < 3; ++c) {
      Corner corner;
      for (int i = 0; i < 3; ++i) corner.position[i] = static_cast<float>(p[c][i]);
      pack_normal(normals[f][c], corner.normal);
      pack_normal(normal.cast<float>(), corner.face_normal);
      corner.material = material_of(mesh, f);
      packed.corners.push_back(corner);
      if (mesh.has_details()) packed.details.push_back(detail_of(*mesh.surface, f, c));
    }
  }
  return packed;
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
  constexpr GLsizei kStride = sizeof(Corner);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride,
                        buffer_offset(offsetof(Corner, position)));
  glVertexAttribPointer(1, 3, GL_SHORT, GL_TRUE, kStride, buffer_offset(offsetof(Corner, normal)));
  glVertexAttribPointer(2, 3, GL_SHORT, GL_TRUE, kStride,
                        buffer_offset(offsetof(Corner, face_normal)));
  glVertexAttribIPointer(3, 1, GL_UNSIGNED_INT, kStride, buffer_offset(offsetof(Corner, material)));
  for (GLuint location = 0; location < 4; ++location) glEnableVertexAttribArray(location);
}

void describe_details() {
  constexpr GLsizei kStride = sizeof(CornerDetail);
  glVertexAttribPointer(4, 4, GL_FLOAT, GL_FALSE, kStride,
                        buffer_offset(offsetof(CornerDetail, coordinates)));
  glVertexAttribPointer(5, 4, GL_UNSIGNED_SHORT, GL_TRUE, kStride,
                        buffer_offset(offsetof(CornerDetail, colour)));
  glVertexAttribPointer(6, 4, GL_SHORT, GL_TRUE, kStride,
                        buffer_offset(offsetof(CornerDetail, tangent)));
  for (GLuint location = 4; location < 7; ++location) glEnableVertexAttribArray(location);
}

// Linear, of the whole image.
Vec3 mean_of(const TextureImage& image) {
  const std::uint8_t* const p = image.levels.back().rgba.data();
  return {linear_from_srgb_byte(p[0]), linear_from_srgb_byte(p[1]), linear_from_srgb_byte(p[2])};
}

// Colour of a face, with its texture and its corners' colours.
Vec3 face_colour(const DrawnMesh& mesh, std::size_t face) {
  static const Material plain;
  const std::uint32_t m = material_of(mesh, face);
  const Material& material = mesh.materials.empty() ? plain : mesh.materials[m];
  Vec3 out;
  for (int i = 0; i < 3; ++i)
    out[i] = unit_or(material.base_colour[static_cast<std::size_t>(i)], 1.0f);
  if (!mesh.has_details()) return out;
  const SurfaceLook& look = *mesh.surface;
  if (const TextureUse& use = look.finishes[m].base_colour)
    out = out.cwiseProduct(mean_of(*look.images[static_cast<std::size_t>(use.image)]));
  if (look.colours.empty()) return out;
  const auto& c = look.colours[face];
  return out.cwiseProduct(((c[0] + c[1] + c[2]) / 3).head<3>().cast<double>());
}

std::array<float, 3> mean_colour(const DrawnMesh& mesh) {
  Vec3 sum = Vec3::Zero();
  double weight = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Index3& t = mesh.triangles[f];
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double area = (b - a).cross(c - a).norm();
    if (!std::isfinite(area)) continue;
    sum += area * face_colour(mesh, f);
    weight += area;
  }
  if (!(weight > 0)) return {1, 1, 1};
  const Vec3 mean = sum / weight;
  return {float(mean.x()), float(mean.y()), float(mean.z())};
}

}  // namespace

UploadedMesh upload_mesh(const PictureMesh& given, std::size_t texture_bytes) {
  const DrawnMesh mesh(given, texture_bytes_left(texture_bytes));
  UploadedMesh out;
  out.box = finite_box(mesh);
  if (!out.box.empty()) out.centre = out.box.centre();
  if (const double size = out.box.diagonal(); size > 0) out.scale = 1 / size;
  out.mean_colour = mean_colour(mesh);
  const PackedMesh packed = pack_mesh(mesh, out);
  out.num_corners = static_cast<GLsizei>(packed.corners.size());
  if (out.empty()) return out;
  out.vertex_array = GlVertexArray::create();
  glBindVertexArray(out.vertex_array.id());
  out.corners =
      make_buffer(GL_ARRAY_BUFFER, packed.corners.data(), packed.corners.size() * sizeof(Corner));
  describe_corners();
  if (mesh.has_details()) {
    out.details = make_buffer(GL_ARRAY_BUFFER, packed.details.data(),
                              packed.details.size() * sizeof(CornerDetail));
    describe_details();
    out.surface.emplace(*mesh.surface);
  }
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
