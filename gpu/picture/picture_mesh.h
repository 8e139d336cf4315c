// Private to gpu: a mesh and its materials in graphics memory, for pictures and for live views.
#pragma once

#include <epoxy/gl.h>

#include "core/picture/picture_frame.h"
#include "gpu/egl/gl_objects.h"

namespace trivet {

/// Shaders find position, normal, face normal and material at locations 0 to 3, and two texels of
/// `material_texture` per material: base colour; roughness and metallic.
struct UploadedMesh {
  GlVertexArray vertex_array;
  GlBuffer corners, materials;
  GlTexture corner_texture, material_texture;
  GLsizei num_opaque = 0, num_see_through = 0;  // corners; the opaque ones come first
  // Corners are stored as (position - centre) * scale, so that float32 holds any mesh.
  Vec3 centre = Vec3::Zero();
  double scale = 1;
  Aabb box;                            // object frame
  std::array<float, 3> mean_colour{};  // of its faces, linear RGB, by area

  bool empty() const { return num_opaque + num_see_through == 0; }
};

/// @throws Error (Environment) for lack of graphics memory.
UploadedMesh upload_mesh(const PictureMesh& mesh);

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
