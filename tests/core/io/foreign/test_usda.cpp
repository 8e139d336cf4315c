// USD as text: poses, shapes, masses and joints with known answers, and poses written as overs.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "core/io/foreign/usd/read_usda.h"
#include "core/io/text/file_bytes.h"

namespace trivet {
namespace {

using namespace trivet::test;

constexpr double kUsdaClose = 1e-12;

const std::string kMetres = "#usda 1.0\n(\n  metersPerUnit = 1\n  upAxis = \"Z\"\n)\n";
const std::string kBox =
    "def Cube \"c\" (prepend apiSchemas = [\"PhysicsCollisionAPI\"]) { double size = 0.2 }\n";

std::string ops(const std::string& lines, const std::string& order) {
  return lines + "\nuniform token[] xformOpOrder = [" + order + "]\n";
}
std::string usda_body(const std::string& name, const std::string& content,
                      const std::string& apis = "") {
  return "def Xform \"" + name + "\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\"" + apis +
         "])\n{\n" + content + kBox + "}\n";
}

ForeignScene scene_of_usda(const std::string& text) {
  const TemporaryFolder folder;
  write_text(folder.file("scene.usda"), text);
  return read_usda(folder.file("scene.usda"), {}, no_mesh);
}
Pose pose_of_usda(const std::string& content) {
  return scene_of_usda(kMetres + usda_body("b", content)).bodies.at(0).pose;
}

void expect_axes(const Pose& pose, const Vec3& x, const Vec3& y) {
  const Mat3 m = pose.rotation.matrix();
  EXPECT_LT((m.col(0) - x).norm(), kUsdaClose) << m;
  EXPECT_LT((m.col(1) - y).norm(), kUsdaClose) << m;
}

Aabb box_of(const ForeignBody& body) {
  Aabb box;
  for (const ForeignCollider& c : body.colliders)
    for (const Vec3& v : c.mesh->vertices)
      box.extend(composed(body.pose, composed(c.pose, {{}, v})).translation);
  return box;
}

TEST(Usda, UnitsAndAxesAreThoseOfTheLayer) {
  const ForeignScene scene = scene_of_usda(
      "#usda 1.0\n(\n  upAxis = \"Y\"\n)\n" +
      usda_body("b", ops("double3 xformOp:translate = (100, 50, 25)", "\"xformOp:translate\"")));
  // Centimetres with y up, as USD has it where nothing is said: y becomes z, z becomes -y.
  EXPECT_LT((scene.bodies.at(0).pose.translation - Vec3(1, -0.25, 0.5)).norm(), kUsdaClose);
  EXPECT_NEAR(box_of(scene.bodies[0]).diagonal(), 0.002 * std::sqrt(3.0), kUsdaClose);
}

TEST(Usda, TurnsAreAsTheirNamesSay) {
  // First about x, then about y: x stays for the first turn and goes to -z by the second.
  expect_axes(pose_of_usda(ops("float3 xformOp:rotateXYZ = (90, 90, 0)", "\"xformOp:rotateXYZ\"")),
              {0, 0, -1}, {1, 0, 0});
  // First about z, then about y, then about x.
  expect_axes(pose_of_usda(ops("float3 xformOp:rotateZYX = (90, 0, 90)", "\"xformOp:rotateZYX\"")),
              {0, 0, 1}, {-1, 0, 0});
  expect_axes(pose_of_usda(ops("float xformOp:rotateZ = 90", "\"xformOp:rotateZ\"")), {0, 1, 0},
              {-1, 0, 0});
  expect_axes(pose_of_usda(ops("quatf xformOp:orient = (1, 0, 0, 1)", "\"xformOp:orient\"")),
              {0, 1, 0}, {-1, 0, 0});
}

TEST(Usda, MatricesHaveTheTranslationInTheirLastRow) {
  const Pose pose = pose_of_usda(
      ops("matrix4d xformOp:transform = ((0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 1, 0), (1, 2, 3, 1))",
          "\"xformOp:transform\""));
  EXPECT_EQ(pose.translation, Vec3(1, 2, 3));
  expect_axes(pose, {0, 1, 0}, {-1, 0, 0});
}

TEST(Usda, PivotsAreTakenBack) {
  // A quarter turn about the point (1, 0, 0): the origin goes to (1, -1, 0).
  const Pose pose = pose_of_usda(
      ops("float3 xformOp:translate:pivot = (1, 0, 0)\nfloat xformOp:rotateZ = 90",
          "\"xformOp:translate:pivot\", \"xformOp:rotateZ\", \"!invert!xformOp:translate:pivot\""));
  EXPECT_LT((pose.translation - Vec3(1, -1, 0)).norm(), kUsdaClose);
}

TEST(Usda, ScalesAreOfTheShape) {
  const ForeignScene scene = scene_of_usda(
      kMetres + "def Xform \"p\" {\n" +
      ops("float xformOp:rotateZ = 90\nfloat3 xformOp:scale = (2, 3, 4)",
          "\"xformOp:rotateZ\", \"xformOp:scale\"") +
      usda_body("b", ops("double3 xformOp:translate = (1, 0, 0)", "\"xformOp:translate\"")) + "}");
  const ForeignBody& body = scene.bodies.at(0);
  EXPECT_LT((body.pose.translation - Vec3(0, 2, 0)).norm(), kUsdaClose);
  const Vec3 size = box_of(body).upper - box_of(body).lower;
  EXPECT_LT((size - Vec3(0.6, 0.4, 0.8)).norm(), kUsdaClose);
  EXPECT_LT((box_of(body).centre() - Vec3(0, 2, 0)).norm(), kUsdaClose);
}

TEST(Usda, ResetStacksAreInTheWorld) {
  const ForeignScene scene =
      scene_of_usda(kMetres + "def Xform \"p\" {\n" +
                    ops("double3 xformOp:translate = (5, 0, 0)", "\"xformOp:translate\"") +
                    usda_body("b", ops("double3 xformOp:translate = (1, 0, 0)",
                                       "\"!resetXformStack!\", \"xformOp:translate\"")) +
                    "}");
  EXPECT_EQ(scene.bodies.at(0).pose.translation, Vec3(1, 0, 0));
}

TEST(Usda, ShapesHaveTheirSizes) {
  const std::string head = "(prepend apiSchemas = [\"PhysicsCollisionAPI\"]) {\n";
  const ForeignScene scene = scene_of_usda(
      kMetres + "def Sphere \"sphere\" " + head + "double radius = 0.5 }\n" +
      "def Cylinder \"cylinder\" " + head + "token axis = \"X\"\ndouble radius = 0.5\n" +
      "double height = 4 }\n" + "def Capsule \"capsule\" " + head +
      "double radius = 0.5\ndouble height = 2 }\n" + "def Cone \"cone\" " + head +
      "token axis = \"Y\" }\n" + "def Cube \"cube\" " + head + "}\n" +
      "def Mesh \"mesh\" (prepend apiSchemas = [\"PhysicsCollisionAPI\", "
      "\"PhysicsMeshCollisionAPI\"]) {\nuniform token physics:approximation = \"convexHull\"\n"
      "point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 3)]\n"
      "int[] faceVertexCounts = [4, 3]\nint[] faceVertexIndices = [3, 2, 1, 0, 0, 1, 4]\n}\n");
  ASSERT_EQ(scene.bodies.size(), 6u);
  const Vec3 sizes[] = {{1, 1, 1}, {4, 1, 1}, {1, 1, 3}, {2, 2, 2}, {2, 2, 2}, {1, 1, 3}};
  for (size_t i = 0; i < 6; ++i) {
    const Aabb box = box_of(scene.bodies[i]);
    EXPECT_LT((box.upper - box.lower - sizes[i]).norm(), 1e-12) << scene.bodies[i].name;
    EXPECT_TRUE(scene.bodies[i].fixed);
  }
  EXPECT_EQ(scene.bodies[5].colliders[0].mesh->triangles.size(), 6u);  // the hull
  EXPECT_TRUE(scene.unread.empty());
}

TEST(Usda, TrueMeshesAreCutIntoTriangles) {
  const std::string text =
      "def Mesh \"m\" (prepend apiSchemas = [\"PhysicsCollisionAPI\"]) {\n"
      "point3f[] points = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (1, 0.5, 0), (0, 2, 0)]\n"
      "int[] faceVertexCounts = [5]\nint[] faceVertexIndices = [0, 1, 2, 3, 4]\n";
  const auto area = [&](const std::string& more) {
    const ForeignScene scene = scene_of_usda(kMetres + text + more + "}\n");
    double sum = 0;
    const Mesh& mesh = *scene.bodies.at(0).colliders.at(0).mesh;
    for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
      const Triangle t = mesh.triangle(f);
      sum += (t[1] - t[0]).cross(t[2] - t[0]).z() / 2;
    }
    return sum;
  };
  // A square of 4 less the notch of 1.5; the left hand turns all faces over.
  EXPECT_NEAR(area(""), 2.5, 1e-12);
  EXPECT_NEAR(area("uniform token orientation = \"leftHanded\"\n"), -2.5, 1e-12);
}

TEST(Usda, FacesThatDoNotFitAreNamed) {
  for (const char* faces :
       {"[3]\nint[] faceVertexIndices = [0, 1, 9]", "[4]\nint[] faceVertexIndices = [0, 1, 2]",
        "[-3]\nint[] faceVertexIndices = [0, 1, 2]", "[1e300]\nint[] faceVertexIndices = [0, 1, 2]",
        "[nan]\nint[] faceVertexIndices = [0, 1, 2]",
        "[3]\nint[] faceVertexIndices = [0, 1, inf]"}) {
    const ForeignScene scene = scene_of_usda(
        kMetres +
        "def Mesh \"m\" (prepend apiSchemas = [\"PhysicsCollisionAPI\"]) {\n"
        "point3f[] points = [(0, 0, 0), (2, 0, 0), (2, 2, 0)]\nint[] faceVertexCounts = " +
        faces + "\n}\n");
    EXPECT_TRUE(scene.bodies.empty());
    ASSERT_FALSE(scene.unread.empty()) << faces;
    EXPECT_NE(in_english(scene.unread[0]).find("/m: "), std::string::npos);
  }
}

TEST(Usda, MassesAreInTheirUnits) {
  const ForeignScene scene = scene_of_usda(
      "#usda 1.0\n(\n  metersPerUnit = 0.01\n  kilogramsPerUnit = 0.001\n  upAxis = \"Z\"\n)\n" +
      usda_body("grams",
                "float physics:mass = 500\npoint3f physics:centerOfMass = (0, 0, 2)\n"
                "float3 physics:diagonalInertia = (100, 100, 200)\n",
                ", \"PhysicsMassAPI\"") +
      // 0.2 cm cubed of 10 g per cubic centimetre.
      usda_body("dense", "float physics:density = 10\n", ", \"PhysicsMassAPI\"") +
      usda_body("plain", ""));
  const GivenMass& mass = scene.bodies.at(0).mass.value();
  EXPECT_NEAR(mass.kilograms, 0.5, kUsdaClose);
  EXPECT_LT((mass.centre.value() - Vec3(0, 0, 0.02)).norm(), kUsdaClose);
  EXPECT_NEAR(mass.inertia.value()(2, 2), 200e-7, 1e-18);
  EXPECT_NEAR(scene.bodies.at(1).mass.value().kilograms, 8e-5, 1e-15);
  EXPECT_FALSE(scene.bodies.at(2).mass);
}

TEST(Usda, FrictionIsThatOfTheNearestMaterial) {
  const std::string material =
      "def Material \"ice\" (prepend apiSchemas = [\"PhysicsMaterialAPI\"]) {\n"
      "float physics:staticFriction = 0.05\n"
      "uniform token physxMaterial:frictionCombineMode = \"min\"\n}\n";
  const ForeignScene scene = scene_of_usda(
      kMetres + material + usda_body("slippery", "rel material:binding:physics = </ice>\n") +
      usda_body("plain", ""));
  EXPECT_EQ(scene.bodies.at(0).colliders.at(0).bits.friction, 0.05);
  EXPECT_EQ(scene.bodies.at(1).colliders.at(0).bits.friction, 0.5);
  EXPECT_EQ(scene.friction_rule, FrictionRule::Smaller);
}

TEST(Usda, FixedJointsMakeOneBody) {
  const ForeignScene scene = scene_of_usda(
      kMetres + usda_body("a", "") +
      usda_body("b", ops("double3 xformOp:translate = (1, 0, 0)", "\"xformOp:translate\"")) +
      "def PhysicsFixedJoint \"weld\" { rel physics:body0 = </a>\nrel physics:body1 = </b> }\n");
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_FALSE(scene.bodies[0].fixed);
  EXPECT_EQ(scene.bodies[0].colliders.size(), 2u);
  EXPECT_NEAR(box_of(scene.bodies[0]).upper.x(), 1.1, kUsdaClose);
  // Both prims move with it.
  const std::string over = usda_over_layer(scene, {{0, {{}, Vec3(0, 0, 2)}}}, "./s.usda");
  EXPECT_NE(over.find("over \"a\""), std::string::npos);
  EXPECT_NE(over.find("double3 xformOp:translate = (1, 0, 2)"), std::string::npos);
}

TEST(Usda, PairsAreFiltered) {
  const std::string bodies =
      usda_body("a", "rel physics:filteredPairs = </b>\n", ", \"PhysicsFilteredPairsAPI\"") +
      usda_body("b", "") + usda_body("c", "");
  const ForeignScene scene = scene_of_usda(
      kMetres + bodies +
      "def PhysicsCollisionGroup \"g\" (prepend apiSchemas = [\"CollectionAPI:colliders\"]) {\n"
      "rel collection:colliders:includes = [</b>, </c>]\nrel physics:filteredGroups = </g>\n}\n");
  ASSERT_EQ(scene.excluded.size(), 2u);
  EXPECT_EQ(scene.excluded[0], std::make_pair(std::string("a"), std::string("b")));
  EXPECT_EQ(scene.excluded[1], std::make_pair(std::string("b"), std::string("c")));
}

TEST(Usda, TheDrawerIsAsInOtherFormats) {
  const std::string file =
      std::string(TRIVET_SOURCE_DIR) + "/tests/core/io/foreign/cases/drawer.usda";
  const ForeignScene scene = read_usda(file, {}, no_mesh);
  EXPECT_TRUE(scene.unread.empty());
  ASSERT_EQ(scene.joints.size(), 2u);
  EXPECT_EQ(scene.joints[0].name, "slide");
  EXPECT_NEAR(scene.joints[0].value, 0.2, kUsdaClose);
  EXPECT_LT((scene.joints[0].axis - Vec3(0, -1, 0)).norm(), kUsdaClose);
  EXPECT_EQ(scene.joints[0].frames, std::vector<std::string>{"cabinet"});
  EXPECT_EQ(scene.joints[1].name, "lid");
  EXPECT_NEAR(scene.joints[1].value, 0, kUsdaClose);
  EXPECT_NEAR(scene.joints[1].upper, 90, 1e-9);
  EXPECT_LT((scene.joints[1].anchor - Vec3(0, 0.2, 0.43)).norm(), kUsdaClose);
  EXPECT_TRUE(find_body(scene, "cabinet")->fixed);
  EXPECT_TRUE(find_body(scene, "drawer")->is_link);
  EXPECT_EQ(find_body(scene, "drawer")->pose.translation, Vec3(0, -0.21, 0.2));
}

/// Ops of a body in a moved, turned and scaled parent.
struct WrittenOps {
  const char* name;
  std::string lines;
};

class UsdaOvers : public testing::TestWithParam<WrittenOps> {};

// The pose that is written is read back, and the layer below has not changed.
TEST_P(UsdaOvers, GiveThePose) {
  for (const char* scale : {"(2, 2, 2)", "(2, 3, 4)"}) {
    const TemporaryFolder folder;
    const std::string text =
        kMetres + "def Xform \"p\" {\n" +
        ops("double3 xformOp:translate = (5, 0, 0)\nfloat xformOp:rotateX = 30\n"
            "float3 xformOp:scale = " +
                std::string(scale),
            "\"xformOp:translate\", \"xformOp:rotateX\", \"xformOp:scale\"") +
        usda_body("b", GetParam().lines) + "}\n";
    write_text(folder.file("scene.usda"), text);
    const ForeignScene scene = read_usda(folder.file("scene.usda"), {}, no_mesh);
    const Pose old = scene.bodies.at(0).pose;
    const Pose moves[] = {{old.rotation, old.translation + Vec3(0, 0, 0.25)},
                          {turn_about(Vec3::UnitY(), 20).normalized() * old.rotation,
                           old.translation + Vec3(0.5, 0, -0.125)}};
    std::string below = "scene.usda";
    for (const Pose& pose : moves) {
      // The second over lies over the first.
      const ForeignScene before = read_usda(folder.file(below), {}, no_mesh);
      const std::string over = usda_over_layer(before, {{0, pose}}, "./" + below);
      below.insert(0, "over ");
      write_text(folder.file(below), over);
      const ForeignScene after = read_usda(folder.file(below), {}, no_mesh);
      ASSERT_EQ(after.bodies.size(), 1u) << over;
      const ForeignBody& body = after.bodies[0];
      // The frame of a sheared body is a choice: its box is not.
      const Aabb want = box_of({"", false, false, false, pose, scene.bodies[0].colliders, {}, {}});
      EXPECT_LT((box_of(body).lower - want.lower).norm(), 1e-11) << over;
      EXPECT_LT((box_of(body).upper - want.upper).norm(), 1e-11) << over;
      EXPECT_LT((body.pose.translation - pose.translation).norm(), 1e-12) << over;
    }
    EXPECT_EQ(file_bytes(folder.file("scene.usda"), 1 << 20), text);
  }
}

const WrittenOps kWrittenOps[] = {
    {"None", ""},
    {"Translate", ops("double3 xformOp:translate = (1, 2, 3)", "\"xformOp:translate\"")},
    {"Orient", ops("float3 xformOp:translate = (1, 2, 3)\nquatf xformOp:orient = (1, 0, 0, 1)",
                   "\"xformOp:translate\", \"xformOp:orient\"")},
    {"RotateAndScale",
     ops("double3 xformOp:translate = (1, 2, 3)\nfloat3 xformOp:rotateXYZ = (10, 20, 30)\n"
         "float3 xformOp:scale = (1, 2, 0.5)",
         "\"xformOp:translate\", \"xformOp:rotateXYZ\", \"xformOp:scale\"")},
    {"Matrix",
     ops("matrix4d xformOp:transform = ((0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 1, 0), (1, 2, 3, 1))",
         "\"xformOp:transform\"")},
    {"Pivot",
     ops("float3 xformOp:translate:pivot = (1, 0, 0)\nfloat xformOp:rotateZ = 90",
         "\"xformOp:translate:pivot\", \"xformOp:rotateZ\", \"!invert!xformOp:translate:pivot\"")},
    {"Reset",
     ops("double3 xformOp:translate = (1, 2, 3)", "\"!resetXformStack!\", \"xformOp:translate\"")},
};
INSTANTIATE_TEST_SUITE_P(Ops, UsdaOvers, testing::ValuesIn(kWrittenOps),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Usda, OnlyNumbersThatMovedAreWritten) {
  const ForeignScene scene =
      scene_of_usda(kMetres + usda_body("b", ops("float3 xformOp:translate = (0.1, 0.2, 0.3)\n"
                                                 "quatf xformOp:orient = (1, 0, 0, 0)",
                                                 "\"xformOp:translate\", \"xformOp:orient\"")));
  const Pose up{scene.bodies.at(0).pose.rotation,
                scene.bodies[0].pose.translation + Vec3(0, 0, 0.25)};
  EXPECT_EQ(usda_over_layer(scene, {{0, up}}, "./s.usda"),
            "#usda 1.0\n(\n    metersPerUnit = 1\n    upAxis = \"Z\"\n    subLayers = [\n"
            "        @./s.usda@\n    ]\n)\n\nover \"b\"\n{\n"
            "    float3 xformOp:translate = (0.1, 0.2, 0.55)\n}\n");
  EXPECT_EQ(usda_over_layer(scene, {{0, scene.bodies[0].pose}}, "./s.usda").find("over"),
            std::string::npos);
}

}  // namespace
}  // namespace trivet
