// Private to gpu: the triangles of a picture in graphics memory.
#pragma once

#include <epoxy/gl.h>

#include <vector>

#include "gpu/gl_objects.h"
#include "gpu/picture_frame.h"

namespace trivet {

/// Unit normals per triangle corner, object frame: the file's where they are usable, else the mean
/// of the faces around the vertex that meet this one at less than the crease angle.
/// @return #F x 3.
std::vector<std::array<Eigen::Vector3f, 3>> picture_normals(const PictureMesh& mesh);

/// All objects of a scene, ready to be drawn; a mesh is stored once however many objects share it.
class PictureGeometry {
 public:
  /// @throws Error (Environment) for lack of graphics memory.
  PictureGeometry(const PictureScene& scene, const PictureFrame& frame);

  /// Opaque triangles need no fragment shader for a shadow, see-through ones do.
  enum class Part { Opaque, SeeThrough };

  /// Draws that part of all objects with the program in use, which finds position, normal, face
  /// normal and material at locations 0 to 3, the texture buffers of the materials on unit 0
  /// and of the corners on unit 1, and its uniforms `frame_from_object`, `frame_from_normal`,
  /// `highlight`, `seed` and `first_triangle` set.
  void draw(const GlProgram& program, Part part) const;

  /// Corners of the objects' boxes, frame: all objects lie in their convex hull.
  const std::vector<Vec3>& hull_points() const { return m_hull_points; }

 private:
  struct Mesh {
    GlVertexArray vertex_array;
    GlBuffer corners, materials;
    GlTexture corner_texture, material_texture;
    GLsizei num_opaque = 0, num_see_through = 0;  // corners; the opaque ones come first
    // Corners are stored as (position - centre) * scale, so that float32 holds any mesh.
    Vec3 centre = Vec3::Zero();
    double scale = 1;
    Aabb box;  // object frame
  };
  struct Instance {
    std::size_t mesh = 0;
    Eigen::Matrix4f frame_from_object;
    Eigen::Matrix3f frame_from_normal;
    Eigen::Vector4f highlight;
  };
  static Mesh upload(const PictureMesh& mesh);
  void add_instance(const PictureObject& object, std::size_t mesh, const PictureFrame& frame);

  std::vector<Mesh> m_meshes;
  std::vector<Instance> m_instances;
  std::vector<Vec3> m_hull_points;
};

}  // namespace trivet
