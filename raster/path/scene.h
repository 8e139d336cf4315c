// A scene in the picture frame, ready for rays. Private.
#pragma once

#include <vector>

#include "core/index/instance_rays.h"
#include "core/picture/frame.h"
#include "raster/path/texture_lookup.h"

namespace trivet {

enum class Finish {
  Opaque,
  Thin,   // of an open mesh: a sheet that covers a share of what is behind it
  Glass,  // of a closed mesh: refracts, and absorbs along the way
  Absent  // cut out by its texture: rays go on
};

struct PathMaterial {
  Vec3f base;  // linear RGB
  float alpha = 1, metallic = 0, roughness = 0.6f;
  Finish finish = Finish::Opaque;
  Vec3f absorbed = Vec3f::Zero();  // of glass: per length of the picture frame, by colour
  Vec3f emitted = Vec3f::Zero();   // radiance
  float index = 1.5f;              // of refraction, of glass
};

/// Point where a ray meets a surface, picture frame.
struct SurfacePoint {
  Vec3f position;
  Vec3f face;    // unit normal of the face, towards where the ray came from
  Vec3f normal;  // smooth one, on the same side
  Vec3f start;   // of rays that leave: lifted off the triangle as far as the smooth surface is
  bool outside;  // the ray came from where the face's front is
  PathMaterial material;
};

class PathScene {
 public:
  /// Triangles that are not finite are left out. On all cores of the arena.
  /// @throws Error (Environment) for lack of memory.
  PathScene(const PictureScene& scene, const PictureFrame& frame);

  const InstanceRays& rays() const { return m_rays; }
  /// @param width  of the ray's cone at the hit: textures are looked up over it.
  SurfacePoint surface(const RayPacket& rays, const HitPacket& hits, int lane, float width) const;

 private:
  struct Mesh {
    std::uint32_t id = 0;
    Vec3 centre = Vec3::Zero();
    double scale = 1, diagonal = 0;  // vertices are (position - centre) * scale; object frame
    std::vector<Vec3f> vertices;
    std::vector<Index3> triangles;
    std::vector<std::array<Vec3f, 3>> normals;
    std::vector<std::uint32_t> material;  // of each triangle
    std::vector<PathMaterial> materials;
    std::shared_ptr<const SurfaceLook> look;  // textures and more; else null
    std::vector<std::uint32_t> look_face;     // of each triangle, if there is a look
  };
  struct Instance {
    std::size_t mesh;
    Eigen::Matrix3f linear, normal;  // frame_from_mesh
    float scale;                     // of lengths
    std::optional<std::array<float, 4>> highlight;
  };
  void add_mesh(const PictureMesh& mesh);
  static float bulge(const Instance& instance, const Mesh& mesh, std::uint32_t face,
                     const std::array<float, 3>& weights, float side);
  static PassedAt passed_at(const Mesh& mesh);
  static void apply_look(const Instance& instance, const FaceLook& look, const Vec3f& smooth,
                         SurfacePoint& out);
  void add_instance(const PictureObject& object, std::size_t mesh, const PictureFrame& frame);

  InstanceRays m_rays;
  std::vector<Mesh> m_meshes;
  std::vector<Instance> m_instances;
  std::size_t m_texture_bytes = 0;
};

}  // namespace trivet
