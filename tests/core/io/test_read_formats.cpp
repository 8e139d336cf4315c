// Every format: the same tetrahedron, its frame, its appearance.
#include <cmath>

#include "core/io/io_testing.h"
#include "core/io/process/sandboxed_import.h"
#include "core/io/read_model.h"

namespace trivet {
namespace {

using testing::expect_parts;
using testing::reference_triangles;
using testing::same_triangles;
using testing::triangles_of;

class ReadFormats : public testing::IoTest {
 protected:
  /// Reads the file and compares it bit for bit with the independent reader.
  Model read(const std::string& name, const std::string& bytes) const {
    Model model = read_model(write(name, bytes));
    EXPECT_TRUE(same_triangles(triangles_of(model.mesh), reference_triangles(path(name)))) << name;
    EXPECT_EQ(model.mesh.triangles.size(), 4u) << name;
    EXPECT_EQ(model.mesh.vertices.size(), 4u) << name;
    EXPECT_EQ(model.face_material.size(), 4u) << name;
    EXPECT_GE(model.materials.size(), 1u) << name;
    EXPECT_EQ(model.path, path(name));
    return model;
  }
};

bool has_vertex(const Model& model, const Vec3& p) {
  for (const Vec3& v : model.mesh.vertices)
    if (v == p) return true;
  return false;
}

TEST_F(ReadFormats, LeavesUpAndUnitOpenForPlainFormats) {
  const std::pair<const char*, std::string> files[] = {
      {"t.obj", testing::tetrahedron_obj()},
      {"t.ply", testing::tetrahedron_ply()},
      {"a.stl", testing::tetrahedron_stl()},
      {"b.stl", testing::tetrahedron_stl_binary()}};
  for (const auto& [name, bytes] : files) {
    const Model model = read(name, bytes);
    EXPECT_EQ(model.format, std::string(name).substr(2));
    EXPECT_EQ(model.up, UpAxis::Z);
    EXPECT_FALSE(model.up_from_format);
    EXPECT_FALSE(model.metres_per_unit);
    EXPECT_TRUE(model.corner_normals.empty()) << name;
  }
}

TEST_F(ReadFormats, AcceptsUpperCaseExtension) { read("T.OBJ", testing::tetrahedron_obj()); }

// assimp 5.2 leaves out vertices whose numbers begin with a point.
TEST_F(ReadFormats, ReadsObjNumbersThatBeginWithTheirPoint) {
  const std::string plain =
      "o .5 name\nv -0.5 0.0 0.0\nv 0.5 0.25 1.\r\nv 0.0 1.5 0.0\nv 0 0 0.75\nv 5 5 5\n"
      "vt 0.5 0.25\nvn 0.0 0.0 1.0\nf 1/1/1 3/1/1 2/1/1\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  std::string bare = plain;
  for (size_t at; (at = bare.find(" 0.")) != bare.npos;) bare.erase(at + 1, 1);
  bare.replace(bare.find("-0.5"), 4, "-.5");
  bare.replace(bare.find("v .5"), 2, "v\t");
  const Model expected = read("plain.obj", plain), found = read_model(write("bare.obj", bare));
  EXPECT_TRUE(same_triangles(triangles_of(expected.mesh), triangles_of(found.mesh)));
  EXPECT_EQ(expected.mesh.vertices, found.mesh.vertices);
}

// Lines go on behind a backslash; a byte order mark is no part of the first one.
TEST_F(ReadFormats, ReadsObjNumbersInContinuedLinesAndBehindAByteOrderMark) {
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const Model expected =
      read("plain.obj", "v 0.5 0 0\nv 0 0.5 0\nv 0 0 0.5\nv 0.25 0.25 0.5\n" + faces);
  const char* const vertices[] = {
      "v 0.5 0 0\nv 0 \\\n .5 0\nv 0 0 \\\r\n .5\nv .25 \\\n .25 \\\n\t.5\n",
      "v .5 0 0\nv 0 .5 \\\n0\nv 0 \\\n0 \\\n.5\nv .25 .25 .5\n",
      "\xef\xbb\xbfv .5 0 0\nv 0 .5 0\nv 0 0 .5\nv .25 .25 .5\n",
      "\xef\xbb\xbfv 0.5 0 0\nv 0 0.5 0\nv 0 0 0.5\nv 0.25 0.25 0.5\n"};
  for (const char* const text : vertices) {
    const Model found = read_model(write("bare.obj", text + faces));
    EXPECT_EQ(expected.mesh.vertices, found.mesh.vertices) << text;
    EXPECT_TRUE(same_triangles(triangles_of(expected.mesh), triangles_of(found.mesh))) << text;
  }
}

TEST_F(ReadFormats, ReadsGltfAsYUpInMetres) {
  const Model text = read("t.gltf", testing::tetrahedron_gltf(R"([{"mesh":0}])", "[0]"));
  const Model binary = read("t.glb", testing::tetrahedron_glb());
  for (const Model& model : {text, binary}) {
    EXPECT_EQ(model.format, "gltf2");
    EXPECT_EQ(model.up, UpAxis::Y);
    EXPECT_TRUE(model.up_from_format);
    EXPECT_EQ(model.metres_per_unit, 1.0);
    const Material& brass = model.materials[model.face_material[0]];
    EXPECT_EQ(brass.name, "brass");
    EXPECT_FLOAT_EQ(brass.base_colour[0], 0.5f);  // already linear
    EXPECT_FLOAT_EQ(brass.base_colour[2], 0.125f);
    EXPECT_FLOAT_EQ(brass.metallic, 0.75f);
    EXPECT_FLOAT_EQ(brass.roughness, 0.25f);
  }
}

// Rotations, a shear through a scaled parent, a mirror: the products must agree bitwise.
TEST_F(ReadFormats, MultipliesGltfNodeTransforms) {
  const std::string nodes = R"([
    {"name":"a","rotation":[0.1,0.7,-0.3,0.640312424],"scale":[1.3,0.7,2.1],"translation":[0.1,-3.7,11.3],
     "children":[1,2]},
    {"name":"b","mesh":0,"rotation":[0.5,-0.5,0.1,0.7],"translation":[1e-3,7,-0.3],"children":[3]},
    {"name":"c","mesh":0,"scale":[-1,1,1]},
    {"name":"d","mesh":0,"matrix":[0.36,0.48,-0.8,0,-0.8,0.6,0,0,0.48,0.64,0.6,0,5.1,6.2,7.3,1]},
    {"name":"e","mesh":0}])";
  write("t.gltf", testing::tetrahedron_gltf(nodes, "[0,4]"));
  const Model model = read_model(path("t.gltf"));
  EXPECT_EQ(model.mesh.triangles.size(), 16u);
  EXPECT_EQ(model.num_nodes, 5);
  EXPECT_TRUE(same_triangles(triangles_of(model.mesh), reference_triangles(path("t.gltf"))));
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_NE(in_english(model.notes[0]).find("mirror"), std::string::npos)
      << in_english(model.notes[0]);
}

TEST_F(ReadFormats, ReadsColladaYUpWithItsUnit) {
  const Model y = read("y.dae", testing::tetrahedron_dae("<up_axis>Y_UP</up_axis>", ""));
  EXPECT_TRUE(has_vertex(y, Vec3(0, 0, 1)));
  const Model z =
      read_model(write("z.dae", testing::tetrahedron_dae("<up_axis>Z_UP</up_axis>",
                                                         "<unit name=\"half\" meter=\"0.5\"/>")));
  EXPECT_TRUE(has_vertex(z, Vec3(0, 1, 0)));   // z of the file points up, y here
  EXPECT_TRUE(has_vertex(z, Vec3(0, 0, -1)));  // y of the file points back
  for (const Model& model : {y, z}) {
    EXPECT_EQ(model.format, "dae");
    EXPECT_EQ(model.up, UpAxis::Y);
    EXPECT_TRUE(model.up_from_format);
  }
  EXPECT_EQ(y.metres_per_unit, 1.0);
  EXPECT_EQ(z.metres_per_unit, 0.5);
}

// The given unit stands for that of the file.
TEST_F(ReadFormats, TakesTheGivenUnitForThatOfTheFile) {
  ImportLimits limits;
  limits.metres_per_unit = 0.001;
  const std::string unit = "<unit name=\"centimeter\" meter=\"0.01\"/>";
  for (const auto& [name, bytes] :
       {std::pair<const char*, std::string>{"c.dae", testing::tetrahedron_dae("", unit)},
        {"f.fbx", testing::tetrahedron_fbx(1, 1)},
        {"o.obj", testing::tetrahedron_obj()}}) {
    const Model model = import_model(write(name, bytes), limits);
    EXPECT_EQ(model.metres_per_unit, 0.001) << name;
    EXPECT_EQ(model.mesh.box().upper, read_model(path(name)).mesh.box().upper) << name;
  }
}

TEST_F(ReadFormats, ReadsAxisAndUnitOfFbx) {
  const Model y = read("y.fbx", testing::tetrahedron_fbx(1, 1));
  EXPECT_EQ(y.up, UpAxis::Y);
  EXPECT_DOUBLE_EQ(y.metres_per_unit.value_or(0), 0.01);
  const Model z = read("z.fbx", testing::tetrahedron_fbx(2, 100));
  EXPECT_EQ(z.up, UpAxis::Z);
  EXPECT_DOUBLE_EQ(z.metres_per_unit.value_or(0), 1.0);
  for (const Model& model : {y, z}) {
    EXPECT_EQ(model.format, "fbx");
    EXPECT_TRUE(model.up_from_format);
    EXPECT_TRUE(has_vertex(model, Vec3(0, 0, 1)));  // as in the file
  }
  const Model x = read("x.fbx", testing::tetrahedron_fbx(0, 1));
  EXPECT_FALSE(x.up_from_format);
  ASSERT_EQ(x.notes.size(), 1u);
  EXPECT_NE(in_english(x.notes[0]).find("up axis"), std::string::npos);
}

TEST_F(ReadFormats, Reads3dsAsYUp) {
  const Model model = read("t.3ds", testing::tetrahedron_3ds());
  EXPECT_EQ(model.format, "3ds");
  EXPECT_EQ(model.up, UpAxis::Y);
  EXPECT_TRUE(has_vertex(model, Vec3(0, 0, -1)));  // y of the file points back
}

TEST_F(ReadFormats, LinearisesObjMaterials) {
  write("t.mtl",
        "newmtl red\nKd 0.5 0 1\nd 0.25\nnewmtl shiny\nKd 1 1 1\nKs 1 1 1\nNs 198\n"
        "newmtl pbr\nPr 0.3\nPm 0.9\n");
  const std::string vertices = "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const Model model = read("t.obj", vertices +
                                        "usemtl red\nf 1 3 2\nf 1 2 4\nusemtl shiny\nf 1 4 3\n"
                                        "usemtl pbr\nf 2 3 4\n");
  const auto material = [&](int f) { return model.materials[model.face_material[f]]; };
  EXPECT_EQ(material(0).name, "red");
  EXPECT_EQ(model.face_material[0], model.face_material[1]);
  EXPECT_NEAR(material(0).base_colour[0], 0.21404114f, 1e-6);
  EXPECT_FLOAT_EQ(material(0).base_colour[1], 0.0f);
  EXPECT_FLOAT_EQ(material(0).base_colour[2], 1.0f);
  EXPECT_FLOAT_EQ(material(0).base_colour[3], 0.25f);
  EXPECT_EQ(material(2).name, "shiny");
  EXPECT_NEAR(material(2).roughness, std::pow(0.01, 0.25), 1e-6);
  EXPECT_NEAR(material(3).roughness, 0.3f, 1e-6);
  EXPECT_NEAR(material(3).metallic, 0.9f, 1e-6);
}

TEST_F(ReadFormats, TransformsNormalsByNodes) {
  // A face in the plane z = 0 below a node that squeezes x: normals need the inverse transpose.
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn nan 0 1\nvn 1 0 1\n"
      "f 1//1 2//2 3//3\n";
  const Model model = read_model(write("t.obj", obj));
  ASSERT_EQ(model.corner_normals.size(), 1u);
  const auto& normals = model.corner_normals[0];
  EXPECT_TRUE(normals[0].isApprox(Eigen::Vector3f::UnitZ()));
  EXPECT_TRUE(normals[1].isApprox(Eigen::Vector3f::UnitZ()));  // dropped, computed from the face
  EXPECT_TRUE(normals[2].isApprox(Eigen::Vector3f(1, 0, 1).normalized()));
}

TEST_F(ReadFormats, TriangulatesPolygonsAndNotesLines) {
  const Model model = read_model(
      write("t.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\nl 1 5\np 5\n"));
  EXPECT_EQ(model.mesh.triangles.size(), 2u);
  std::string notes;
  for (const Sentence& note : model.notes) notes += in_english(note) + "\n";
  expect_parts(notes, {"lines left out: 1"});
}

TEST_F(ReadFormats, KeepsDegenerateTriangles) {
  const Model model =
      read_model(write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\nf 2 2 2\n"));
  EXPECT_EQ(model.mesh.triangles.size(), 3u);
  EXPECT_EQ(model.mesh.vertices.size(), 3u);
}

}  // namespace
}  // namespace trivet
