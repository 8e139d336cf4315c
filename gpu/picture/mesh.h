// Private to gpu: a mesh and its materials in graphics memory, for pictures and for live views.
#pragma once

#include <epoxy/gl.h>

#include <optional>
#include <vector>

#include "core/picture/frame.h"
#include "gpu/egl/gl_objects.h"
#include "gpu/picture/surface_images.h"

namespace trivet {

/// Opaque faces need no fragment shader to cast shadows; of cut-out ones pixels are there or not;
/// see-through ones are mixed with what is behind.
enum class MeshPart { Opaque, Cut, SeeThrough };

/// Corners that are drawn at once: with one part and, of textured meshes, one material.
struct MeshGroup {
  MeshPart part;
  GLint first;
  GLsizei count;
  std::size_t material;  // if textured
};

/// Shaders find position, normal, face normal and material at locations 0 to 3, of textured meshes
/// texture coordinates, colour and tangent at 4 to 6, and two texels of `material_texture` per
/// material: base colour; roughness and metallic.
struct UploadedMesh {
  GlVertexArray vertex_array;
  GlBuffer corners, details, materials;
  GlTexture corner_texture, material_texture;
  std::vector<MeshGroup> groups;  // in the order of the parts
  GLsizei num_corners = 0;
  std::optional<SurfaceImages> surface;  // of textured meshes
  // Corners are stored as (position - centre) * scale, so that float32 holds any mesh.
  Vec3 centre = Vec3::Zero();
  double scale = 1;
  Aabb box;                            // object frame
  std::array<float, 3> mean_colour{};  // of its faces, linear RGB, by area

  bool empty() const { return num_corners == 0; }
  bool textured() const { return surface.has_value(); }
  std::size_t texture_bytes() const { return surface ? surface->num_bytes() : 0; }
};

/// @param texture_bytes  of the scene's meshes before it: bounds those of this one.
/// @throws Error (Environment) for lack of graphics memory.
UploadedMesh upload_mesh(const PictureMesh& mesh, std::size_t texture_bytes);

/// The matrices that place a mesh in the picture frame.
struct MeshPlacement {
  Eigen::Matrix4f frame_from_object = Eigen::Matrix4f::Identity();
  Eigen::Matrix3f frame_from_normal = Eigen::Matrix3f::Identity();
};
MeshPlacement place_mesh(const UploadedMesh& mesh, const Affine& world_from_object,
                         const PictureFrame& frame);

/// Corner of a box selected by bits 0 (x), 1 (y) and 2 (z) of `index`: upper where set.
Vec3 box_corner(const Aabb& box, int index);

}  // namespace trivet
