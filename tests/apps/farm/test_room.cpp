// Rooms around scenes, surfaces of groups, and cameras that see the targets.
#include <gtest/gtest.h>

#include <cmath>

#include "apps/farm/pictures/cameras.h"
#include "apps/farm/pictures/room.h"
#include "ops/files/layout/boxes.h"

namespace trivet::farm {
namespace {

constexpr PhiloxKey kKey{1, 2};

/// A target of 10 cm at the origin; distractors beside it.
struct Boxes {
  Model small = box_model(0.1, 0.1, 0.1), wide = box_model(0.3, 0.02, 0.4);
  LabelledScene scene;

  Boxes() { add("thing_0", small, Vec3(0, 0, 0.05), 1); }
  void add(const std::string& name, const Model& model, const Vec3& at, int id) {
    const auto [mesh, is_new] = scene.meshes.try_emplace(&model);
    if (is_new) mesh->second = picture_mesh(model);
    scene.picture.objects.push_back({&mesh->second, {Mat3::Identity(), at}, std::nullopt});
    LabelledObject object;
    object.name = name;
    object.model_id = id;
    scene.objects.push_back(object);
  }
};

PinholeCamera camera_at(const Vec3& eye) {
  Camera camera;
  camera.eye = eye;
  return pinhole_camera(camera, 40, 30);
}

Recipe recipe_of_things(const std::string& look) {
  return parse_recipe(
      R"({"trivet_recipe": 1, "groups": [{"name": "thing", "on": "floor", "models": [{"model": "a.obj"}])" +
          look + "}]}",
      "recipe.json");
}

TEST(Room, IsBeyondObjectsAndCameras) {
  Boxes boxes;
  LookRanges look;
  look.room = RoomRanges();
  look.room->distance = {0.01, 0.02};
  LookImages none({});
  const std::vector<PinholeCamera> cameras{camera_at({3, -1, 1}), camera_at({-0.5, 0.2, 0.4})};
  for (std::uint64_t k = 0; k < 8; ++k) {
    const RoomMesh room = room_of(look, none, boxes.scene.picture, cameras, kKey, k);
    ASSERT_EQ(room.triangles.size(), 10u);
    ASSERT_EQ(room.look->coordinates[0].size(), 10u);
    for (size_t f = 2; f < 10; ++f) {  // walls: all is on one side of their planes
      const auto at = [&](size_t i) { return room.vertices[room.triangles[f][i]]; };
      const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
      const double middle = normal.dot(Vec3(0, 0, 0.05) - at(0));
      for (const PinholeCamera& camera : cameras)
        EXPECT_GT(normal.dot(camera.eye - at(0)) * (middle > 0 ? 1 : -1), 0.29);
      EXPECT_GT(std::abs(middle), 0.1);
    }
    for (int i = 0; i < 4; ++i) EXPECT_EQ(room.vertices[i].z(), 0);
  }
}

TEST(Room, ChangesNoLabelOfAnObject) {
  Boxes boxes;
  boxes.add("junk_0", boxes.wide, Vec3(0, 0.2, 0.2), 0);
  LookRanges look;
  look.room = RoomRanges();
  LookImages none({});
  const PinholeCamera camera = camera_at({1, -1.4, 0.3});
  const Recipe recipe = recipe_of_things("");
  const DrawnScene plain(boxes.scene, recipe, nullptr, nullptr, {camera}, kKey, 1);
  const DrawnScene in_room(boxes.scene, recipe, &look, &none, {camera}, kKey, 1);
  EXPECT_EQ(plain.picture().objects.size(), 2u);
  EXPECT_EQ(in_room.picture().objects.size(), 3u);
  const Labels without = plain.labels(camera, {}), with = in_room.labels(camera, {});
  ASSERT_EQ(with.objects.size(), 2u);
  EXPECT_EQ(with.objects[0].num_visible, without.objects[0].num_visible);
  EXPECT_GT(with.objects[0].num_visible, 0);
  int walls = 0;
  for (size_t i = 0; i < with.instances.size(); ++i) {
    const bool is_object = without.instances[i] == 1 || without.instances[i] == 2;
    EXPECT_EQ(with.instances[i], is_object ? without.instances[i] : kFloorInstance);
    EXPECT_GT(with.depth[i], 0);
    if (without.depth[i] > 0) {
      EXPECT_LE(with.depth[i], without.depth[i]);
    }
    walls += with.depth[i] != without.depth[i];
  }
  EXPECT_GT(walls, 0);
}

TEST(Room, ImagesAreTiledByMetres) {
  Boxes boxes;
  LookRanges look;
  look.room = RoomRanges();
  look.room->distance = {2, 2}, look.room->tile = {0.5, 0.5}, look.room->height = {3, 3};
  LookImages none({});
  const RoomMesh room = room_of(look, none, boxes.scene.picture, {}, kKey, 0);
  EXPECT_EQ(room.look->coordinates[0][0][1], Eigen::Vector2f(8, 8));  // 4 m of floor
  EXPECT_EQ(room.look->coordinates[0][2][1], Eigen::Vector2f(8, 6));  // and 3 m of wall
}

TEST(Surfaces, AreDrawnForEachObjectOfTheGroup) {
  Boxes boxes;
  boxes.add("thing_1", boxes.small, Vec3(0.3, 0, 0.05), 1);
  boxes.add("other_0", boxes.small, Vec3(0.6, 0, 0.05), 1);
  const Recipe recipe = recipe_of_things(
      R"(, "look": {"roughness": [0.2, 0.4], "metallic": 1, "colour": [[0, 0, 0], [1, 0, 0]]})");
  const DrawnScene drawn(boxes.scene, recipe, nullptr, nullptr, {}, kKey, 5);
  const auto material = [&](const PictureScene& scene, size_t i) {
    const PictureMesh& mesh = *scene.objects[i].mesh;
    const auto look = mesh.look(1 << 20);
    return look ? look->materials.at(0) : mesh.materials[0];
  };
  const Material before = material(boxes.scene.picture, 0);
  for (const size_t i : {0, 1}) {
    const Material m = material(drawn.picture(), i);
    EXPECT_GE(m.roughness, 0.2f);
    EXPECT_LE(m.roughness, 0.4f);
    EXPECT_EQ(m.metallic, 1);
    EXPECT_LE(m.base_colour[0], before.base_colour[0]);
    EXPECT_EQ(m.base_colour[1], 0);
  }
  EXPECT_NE(material(drawn.picture(), 0).roughness, material(drawn.picture(), 1).roughness);
  EXPECT_EQ(drawn.picture().objects[2].mesh, boxes.scene.picture.objects[2].mesh);
  EXPECT_EQ(material(boxes.scene.picture, 0).roughness, before.roughness);
}

TEST(Cameras, SeeWhatIsWantedOfTargets) {
  Boxes boxes;  // a screen hides the target from half of all sides
  boxes.add("junk_0", boxes.wide, Vec3(0, 0.12, 0.2), 0);
  Views views;
  views.width = 64, views.height = 48;
  views.dome.count = 10;
  const auto least = [&](std::uint64_t k) {
    double share = 1;
    for (const LabelView& view : cameras_of(views, boxes.scene, kKey, k))
      share = std::min(share,
                       render_labels(boxes.scene.picture, view.camera).objects[0].visible_share());
    return share;
  };
  EXPECT_LT(least(0), 0.7);
  views.ranges.min_visible = 0.8;
  EXPECT_GE(least(0), 0.8);
  views.ranges.min_visible = 0, views.ranges.min_pixels = 1'000'000;  // none has as many
  EXPECT_EQ(cameras_of(views, boxes.scene, kKey, 0).size(), 10u);
}

}  // namespace
}  // namespace trivet::farm
