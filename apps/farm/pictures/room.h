// A room around a scene, and surfaces of objects, drawn from the recipe's ranges.
#pragma once

#include <memory>

#include "apps/farm/pictures/looks.h"
#include "apps/farm/recipe/recipe.h"
#include "ops/files/labels/labelled_scene.h"
#include "raster/labels/labels.h"

namespace trivet::farm {

/// Floor and walls as triangles.
struct RoomMesh {
  std::vector<Vec3> vertices;
  std::vector<Index3> triangles;
  std::shared_ptr<SurfaceLook> look;

  PictureMesh mesh() const;
};

/// The room of scene k: its walls are beyond the box and all cameras, its floor at z = 0, or below
/// the box where the scene has no floor.
RoomMesh room_of(const LookRanges& ranges, LookImages& images, const PictureScene& scene,
                 const std::vector<PinholeCamera>& cameras, const PhiloxKey& key, std::uint64_t k);

/// Content of a scene's pictures: objects with surfaces of their own, and the room.
class DrawnScene {
 public:
  /// @param look  null: no room. The scene must outlive it.
  DrawnScene(const LabelledScene& scene, const Recipe& recipe, const LookRanges* look,
             LookImages* images, const std::vector<PinholeCamera>& cameras, const PhiloxKey& key,
             std::uint64_t k);
  DrawnScene(const DrawnScene&) = delete;
  DrawnScene& operator=(const DrawnScene&) = delete;

  const PictureScene& picture() const { return m_picture; }
  /// Labels of the objects; floor and walls of a room are the floor.
  Labels labels(const PinholeCamera& camera, const LabelOptions& options) const;

 private:
  void add_room(const RoomMesh& room);

  std::size_t m_num_objects;
  bool m_has_room = false;
  PictureScene m_picture, m_labelled;
  std::vector<std::unique_ptr<PictureMesh>> m_meshes;
  RoomMesh m_room;
};

/// A mesh with another surface: what of it is given.
PictureMesh with_surface(const PictureMesh& mesh, const SurfaceRanges& ranges, const PhiloxKey& key,
                         std::uint64_t k, const std::string& object);

}  // namespace trivet::farm
