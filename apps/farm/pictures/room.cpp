#include "apps/farm/pictures/room.h"

#include <algorithm>

#include "core/picture/frame.h"

namespace trivet::farm {
namespace {

constexpr double kBehindCameras = 0.3, kBesideObjects = 0.05;  // metres to the walls
constexpr float kGrey = 0.6f;

enum RoomMaterial { kFloor, kWall };

class RoomMaker {
 public:
  RoomMaker(double tile) : m_tile(tile) { m_room.look = std::make_shared<SurfaceLook>(); }

  /// A rectangle from a corner along two sides.
  void add(RoomMaterial material, const Vec3& corner, const Vec3& along, const Vec3& up) {
    const auto first = static_cast<Index>(m_room.vertices.size());
    const auto u = static_cast<float>(along.norm() / m_tile),
               v = static_cast<float>(up.norm() / m_tile);
    for (const Vec3& p :
         {corner, Vec3(corner + along), Vec3(corner + along + up), Vec3(corner + up)})
      m_room.vertices.push_back(p);
    m_room.triangles.push_back({first, first + 1, first + 2});
    m_room.triangles.push_back({first, first + 2, first + 3});
    SurfaceLook& look = *m_room.look;
    look.coordinates[0].push_back({Eigen::Vector2f(0, v), {u, v}, {u, 0}});
    look.coordinates[0].push_back({Eigen::Vector2f(0, v), {u, 0}, {0, 0}});
    for (int i = 0; i < 2; ++i) look.face_material.push_back(material);
  }
  /// In the order of RoomMaterial.
  void add_material(const std::array<float, 3>& colour, std::shared_ptr<const TextureImage> image) {
    SurfaceLook& look = *m_room.look;
    Material material;
    material.base_colour = {colour[0], colour[1], colour[2], 1};
    material.roughness = 0.9f;
    look.materials.push_back(material);
    look.finishes.emplace_back();
    if (!image) return;
    look.finishes.back().base_colour.image = static_cast<int>(look.images.size());
    look.images.push_back(std::move(image));
  }
  RoomMesh take() { return std::move(m_room); }

 private:
  double m_tile;
  RoomMesh m_room;
};

std::shared_ptr<const TextureImage> drawn_image(const std::vector<std::string>& names,
                                                LookImages& images, Decision decision) {
  return names.empty() ? nullptr : images.texture(names[decision.index(names.size())]);
}

// "cup" of "cup_12".
const RecipeGroup* group_of(const Recipe& recipe, const std::string& object) {
  const std::string name = object.substr(0, std::min(object.rfind('_'), object.size()));
  for (const RecipeGroup& group : recipe.groups)
    if (group.name == name) return &group;
  return nullptr;
}

}  // namespace

PictureMesh RoomMesh::mesh() const {
  PictureMesh out;
  out.vertices = vertices, out.triangles = triangles;
  out.look = [this](std::size_t) -> std::shared_ptr<const SurfaceLook> { return look; };
  return out;
}

RoomMesh room_of(const LookRanges& ranges, LookImages& images, const PictureScene& scene,
                 const std::vector<PinholeCamera>& cameras, const PhiloxKey& key, std::uint64_t k) {
  const RoomRanges& room = *ranges.room;
  const auto draw = [&](const char* name) {
    return Decision(key, k, std::string("look/room/") + name);
  };
  const Rotation turn = draw("turn").yaw();
  const Vec3 x(turn.w, turn.z, 0), y(-turn.z, turn.w, 0);
  const Aabb box = make_picture_frame(scene).world_box;
  Vec3 middle = (box.lower + box.upper) / 2;
  middle.z() = scene.floor ? 0 : box.lower.z();
  double half = std::max(draw("distance").within(room.distance),
                         (box.upper - box.lower).head<2>().norm() / 2 + kBesideObjects);
  for (const PinholeCamera& camera : cameras) {
    const Vec3 off = camera.eye - middle;
    half = std::max(
        {half, std::abs(off.dot(x)) + kBehindCameras, std::abs(off.dot(y)) + kBehindCameras});
  }
  const Vec3 up(0, 0, draw("height").within(room.height));
  RoomMaker out(draw("tile").within(room.tile));
  out.add(kFloor, middle - half * x - half * y, 2 * half * x, 2 * half * y);
  for (const auto& [side, along] :
       {std::pair(x, y), {y, Vec3(-x)}, {Vec3(-x), Vec3(-y)}, {Vec3(-y), x}})
    out.add(kWall, middle + half * side - half * along, 2 * half * along, up);
  const auto floor = drawn_image(room.floor_images, images, draw("floor"));
  const auto wall = drawn_image(room.wall_images, images, draw("wall"));
  const std::array<float, 3> grey{kGrey, kGrey, kGrey}, white{1, 1, 1};
  out.add_material(ranges.floor ? colour_within(*ranges.floor, {key, k, "look/floor"})
                   : floor      ? white
                                : grey,
                   floor);
  out.add_material(room.walls ? colour_within(*room.walls, draw("walls"))
                   : wall     ? white
                              : grey,
                   wall);
  return out.take();
}

PictureMesh with_surface(const PictureMesh& mesh, const SurfaceRanges& ranges, const PhiloxKey& key,
                         std::uint64_t k, const std::string& object) {
  const auto draw = [&](const char* name) {
    return Decision(key, k, "look/objects/" + object + "/" + name);
  };
  std::optional<float> roughness, metallic;
  if (ranges.roughness) roughness = float(draw("roughness").within(*ranges.roughness));
  if (ranges.metallic) metallic = float(draw("metallic").within(*ranges.metallic));
  std::array<float, 3> colour{1, 1, 1};
  if (ranges.colour) colour = colour_within(*ranges.colour, draw("colour"));
  PictureMesh out = mesh;
  out.source.reset();
  out.look = [mesh, roughness, metallic, colour](std::size_t max_bytes) {
    const auto given = mesh.look ? mesh.look(max_bytes) : nullptr;
    auto look = std::make_shared<SurfaceLook>();
    if (given) {
      *look = *given;
    } else {
      look->materials.assign(mesh.materials.begin(), mesh.materials.end());
      look->face_material.assign(mesh.face_material.begin(), mesh.face_material.end());
    }
    if (look->materials.empty()) look->materials.emplace_back();
    for (Material& material : look->materials) {
      material.roughness = roughness.value_or(material.roughness);
      material.metallic = metallic.value_or(material.metallic);
      for (std::size_t c = 0; c < 3; ++c) material.base_colour[c] *= colour[c];
    }
    return std::shared_ptr<const SurfaceLook>(look);
  };
  return out;
}

DrawnScene::DrawnScene(const LabelledScene& scene, const Recipe& recipe, const LookRanges* look,
                       LookImages* images, const std::vector<PinholeCamera>& cameras,
                       const PhiloxKey& key, std::uint64_t k)
    : m_num_objects(scene.picture.objects.size()),
      m_picture(scene.picture),
      m_labelled(scene.picture) {
  for (std::size_t i = 0; i < m_num_objects; ++i) {
    const std::string& name = scene.objects[i].name;
    const RecipeGroup* const group = group_of(recipe, name);
    if (!group || !group->look) continue;
    m_meshes.push_back(std::make_unique<PictureMesh>(
        with_surface(*m_picture.objects[i].mesh, *group->look, key, k, name)));
    m_picture.objects[i].mesh = m_meshes.back().get();
  }
  if (look && look->room) add_room(room_of(*look, *images, scene.picture, cameras, key, k));
}

void DrawnScene::add_room(const RoomMesh& room) {
  m_room = room;
  m_has_room = true;
  m_meshes.push_back(std::make_unique<PictureMesh>(m_room.mesh()));
  for (PictureScene* const scene : {&m_picture, &m_labelled})
    scene->objects.push_back({m_meshes.back().get(), {}, std::nullopt});
  m_picture.floor = false;
}

Labels DrawnScene::labels(const PinholeCamera& camera, const LabelOptions& options) const {
  Labels out = render_labels(m_labelled, camera, options);
  if (!m_has_room) return out;
  const auto room = static_cast<std::uint16_t>(m_num_objects + 1);
  std::replace(out.instances.begin(), out.instances.end(), room, kFloorInstance);
  out.objects.pop_back();
  return out;
}

}  // namespace trivet::farm
