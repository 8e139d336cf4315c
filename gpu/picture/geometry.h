// Private to gpu: the triangles of a picture in graphics memory.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gpu/picture/store.h"

namespace trivet {

/// All objects of a scene, ready to draw; shared meshes are stored once.
class PictureGeometry {
 public:
  /// @throws Error (Environment) for lack of graphics memory.
  PictureGeometry(const PictureScene& scene, const PictureFrame& frame, PictureStore& store);

  /// Which groups of triangles a program draws.
  struct Which {
    bool solid;                    // opaque ones, else cut-out and see-through ones
    std::optional<bool> textured;  // of textured meshes or of the others; none: both
  };

  /// Draws those of all objects with the program in use, which takes what UploadedMesh has, the
  /// texture buffers of the materials on unit 0 and of the corners on unit 1, its uniforms
  /// `frame_from_object`, `frame_from_normal`, `highlight`, `seed` and `first_triangle`, and, if it
  /// is for textured meshes alone, what FinishUniforms sets.
  void draw(const GlProgram& program, const Which& which) const;

  bool has_textures() const;
  /// True if some surface gives light.
  bool emits() const;

  /// Corners of the objects' boxes, frame: all objects lie in their convex hull.
  const std::vector<Vec3>& hull_points() const { return m_hull_points; }

 private:
  struct Instance {
    std::size_t mesh = 0;
    MeshPlacement placement;
    Eigen::Vector4f highlight;
  };
  void add_instance(const PictureObject& object, std::size_t mesh, const PictureFrame& frame);

  std::vector<std::shared_ptr<const UploadedMesh>> m_meshes;
  std::vector<Instance> m_instances;
  std::vector<Vec3> m_hull_points;
};

}  // namespace trivet
