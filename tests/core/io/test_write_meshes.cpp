// OBJ, PLY and STL: world coordinates, z up, the float32 of exported_positions().
#include "core/io/export.h"
#include "core/io/io_testing.h"
#include "core/io/read_model.h"
#include "core/model/exported_floats.h"

namespace trivet {
namespace {

class WriteMeshes : public testing::IoTest {};

ExportScene scene_of_two() {
  Model model = testing::tetrahedron_model();
  model.materials = {{"red paint", {0.21404114f, 0, 1, 1}, 0, 0.5f},
                     {"", {0.5f, 0.5f, 0.5f, 0.25f}, 1, 0.125f}};
  model.face_material = {1, 0, 1, 0};
  Model other = testing::tetrahedron_model();
  other.materials[0] = {"red paint", {0, 1, 0, 1}, 0, 0.5f};
  Pose pose;
  pose.rotation = Rotation::about_axis(Vec3(1, 2, 3).normalized(), 0.4);
  pose.translation = Vec3(0.123456789, -98.7654321, 1e-3);
  const auto a = std::make_shared<const Model>(model), b = std::make_shared<const Model>(other);
  return {{{"a cup", a, world_from_object(pose, UpAxis::Z, 0.1), ""},
           {"plate", b, Affine(), ""},
           {"again", a, world_from_object(Pose(), UpAxis::Y, 3.3), ""}},
          ""};
}

std::vector<Triangle> expected_triangles(const ExportScene& scene) {
  std::vector<Triangle> out;
  for (const ExportObject& object : scene.objects) {
    const std::vector<Eigen::Vector3f> p = exported_positions(object);
    for (const Index3& t : object.model->mesh.triangles)
      out.push_back({p[t[0]].cast<double>(), p[t[1]].cast<double>(), p[t[2]].cast<double>()});
  }
  return out;
}

TEST_F(WriteMeshes, WritesPlyAndStlExactly) {
  const ExportScene scene = scene_of_two();
  for (const char* name : {"s.ply", "s.stl"}) {
    write_scene(scene, path(name));
    const Model read = read_model(path(name));
    EXPECT_TRUE(
        testing::same_triangles(testing::triangles_of(read.mesh), expected_triangles(scene)))
        << name;
  }
}

TEST_F(WriteMeshes, WritesObjWithNamesMaterialsAndNineDigits) {
  const ExportScene scene = scene_of_two();
  write_scene(scene, path("my scene.obj"));
  const Model read = read_model(path("my scene.obj"));
  const auto found = testing::sorted(testing::triangles_of(read.mesh));
  const auto expected = testing::sorted(expected_triangles(scene));
  ASSERT_EQ(found.size(), expected.size());
  testing::expect_parts(testing::read_bytes(path("my scene.obj")),
                        {"mtllib my scene.mtl\n", "o a_cup\n", "o plate\n", "usemtl red_paint\n",
                         "usemtl material\n", "usemtl red_paint_2\n"});
  // The file states every float32 exactly; assimp's own number reader may be off by one unit.
  for (size_t f = 0; f < found.size(); ++f)
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(found[f][k].isApprox(expected[f][k], 2.4e-7)) << f;

  int red = 0;
  for (const Index id : read.face_material) {
    const Material& m = read.materials[id];
    if (m.name != "red_paint") continue;
    ++red;
    EXPECT_NEAR(m.base_colour[0], 0.21404114f, 1e-6);
    EXPECT_NEAR(m.roughness, 0.5f, 1e-6);
  }
  EXPECT_EQ(red, 4);
}

TEST_F(WriteMeshes, RoundTripsFloatsInObj) {
  const ExportScene scene = scene_of_two();
  write_scene(scene, path("s.obj"));
  std::istringstream in(testing::read_bytes(path("s.obj")));
  std::vector<float> found, expected;
  for (std::string word; in >> word;)
    if (word == "v")
      for (int i = 0; i < 3 && in >> word; ++i) found.push_back(std::strtof(word.c_str(), nullptr));
  for (const ExportObject& object : scene.objects)
    for (const Eigen::Vector3f& p : exported_positions(object))
      expected.insert(expected.end(), p.data(), p.data() + 3);
  EXPECT_EQ(found, expected);
}

TEST_F(WriteMeshes, KeepsDegenerateTriangles) {
  Model model;
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  model.mesh = weld({{a, b, c}, {a, a, b}, {b, b, b}});
  const ExportScene scene{{{"d", std::make_shared<const Model>(model), {}, ""}}, ""};
  for (const char* name : {"s.obj", "s.ply", "s.stl"}) {
    write_scene(scene, path(name));
    EXPECT_EQ(testing::reference_triangles(path(name)).size(), 3u) << name;
  }
}

TEST_F(WriteMeshes, AcceptsHandMadeModelsWithoutMaterials) {
  Model model;
  model.mesh = weld({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}});
  const ExportScene scene{{{"t", std::make_shared<const Model>(model), {}, ""}}, ""};
  for (const char* name : {"s.obj", "s.ply", "s.stl", "s.glb", "S.GLB"}) {
    write_scene(scene, path(name));
    EXPECT_EQ(testing::reference_triangles(path(name)).size(), 1u) << name;
  }
}

// A companion file belongs to the target, or is kept and no file is written.
TEST_F(WriteMeshes, DoesNotOverwriteFilesOfOthers) {
  const ExportScene scene = scene_of_two();
  for (const auto& [target, beside] : {std::pair("s.gltf", "s.bin"), std::pair("t.obj", "t.mtl")}) {
    write(beside, "somebody's");
    const std::string message = testing::error_of([&] { write_scene(scene, path(target)); });
    testing::expect_parts(message, {path(beside), path(target), "accepted: another name"});
    EXPECT_EQ(testing::error_of([&] { check_files_beside(path(target)); }), message);
    EXPECT_EQ(testing::read_bytes(path(beside)), "somebody's");
    EXPECT_FALSE(std::filesystem::exists(path(target)));

    std::filesystem::remove(path(beside));
    write_scene(scene, path(target));
    const std::string whole = testing::read_bytes(path(beside));
    write(beside, "of an older version");
    check_files_beside(path(target));
    write_scene(scene, path(target));  // its own
    EXPECT_EQ(testing::read_bytes(path(beside)), whole);

    write(target, "another scene, with files of other names");
    testing::error_of([&] { write_scene(scene, path(target)); });
    EXPECT_EQ(testing::read_bytes(path(beside)), whole);
  }
  check_files_beside(path("s.glb"));
}

TEST_F(WriteMeshes, IsDeterministic) {
  for (const char* name : {"s.obj", "s.ply", "s.stl"}) {
    write_scene(scene_of_two(), path(name));
    const std::string first = testing::read_bytes(path(name));
    write_scene(scene_of_two(), path(name));
    EXPECT_EQ(testing::read_bytes(path(name)), first);
  }
}

}  // namespace
}  // namespace trivet
