// OBJ as programs write it: each form is the same unit cube, or says what it is not.
#include "core/io/cubes.h"
#include "core/io/look.h"

namespace trivet {
namespace {

using testing::cube_faces_obj;
using testing::cube_obj;
using testing::cube_vertices_obj;
using testing::error_of;
using testing::expect_parts;
using testing::expect_unit_cube;
using testing::joined_notes;
using testing::replaced;
using testing::utf16;

class ReadObj : public testing::IoTest {
 protected:
  void expect_cube(const std::string& text, const std::vector<std::string>& notes = {}) const {
    SCOPED_TRACE(text.substr(0, 400));
    expect_unit_cube(write("a.obj", text), notes);
  }
  void expect_refused(const std::string& text, const std::vector<std::string>& parts) const {
    expect_parts(error_of([&] { read_model(write("b.obj", text)); }), parts);
  }
};

const std::string kNormals = "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 0 1 0\nvn -1 0 0\nvn 1 0 0\n";
const std::string kImage = std::string("\x89PNG\r\n\x1a\n", 8) + "pixels";

TEST_F(ReadObj, TakesAnyLineEndsBlanksAndCapitals) {
  const std::string v = cube_vertices_obj(), f = cube_faces_obj();
  for (const std::string& text :
       {replaced(cube_obj(), "\n", "\r\n"), replaced(cube_obj(), "\n", "\r"),
        replaced(cube_obj(), " ", "\t"), replaced(cube_obj(), " ", "  \t "),
        v + cube_faces_obj("", "\n", " f "), v + cube_faces_obj("", "\n", "\t\tf\t"),
        replaced(v, "v ", "  v ") + f, replaced(v, "v ", "V ") + replaced(f, "f ", "F "),
        v + cube_faces_obj("", " \t\n"), replaced(cube_obj(), "\n", "\n\n \n"),
        cube_obj().substr(0, cube_obj().size() - 1), f + v})
    expect_cube(text);
}

TEST_F(ReadObj, TakesCommentsBehindNumbers) {
  const std::string v = cube_vertices_obj(" # corner"), f = cube_faces_obj();
  for (const std::string& text :
       {cube_vertices_obj() + cube_faces_obj("", " # side\n"),
        cube_vertices_obj() + cube_faces_obj("", "# side 7 8 9\n"),
        cube_vertices_obj() + cube_faces_obj("", "\t#\n"), v + f, cube_vertices_obj("#1 2") + f,
        "# C:\\models\\\n" + cube_obj(), "#\n" + cube_obj() + "# end"})
    expect_cube(text);
}

TEST_F(ReadObj, TakesEncodings) {
  for (const std::string& text :
       {"\xef\xbb\xbf" + cube_obj(), utf16(cube_obj(), false, true), utf16(cube_obj(), true, true),
        utf16(cube_obj(), false, false), utf16(cube_obj(), true, false),
        utf16(replaced(cube_obj(), "\n", "\r\n"), false, true)})
    expect_cube(text);
}

TEST_F(ReadObj, LeavesOutWeightsAndReadsColours) {
  const std::string f = cube_faces_obj();
  expect_cube(cube_vertices_obj(" 1") + f);
  expect_cube(cube_vertices_obj(" 1.0") + f);
  for (const char* weight : {" 0.5", " 0", " -2", " 1e3"})
    expect_cube(cube_vertices_obj(weight) + f, {"weights of vertices left out: 8"});
  for (const char* colour : {" 1 0 0", " 255 0 0", " 1 0 0 0.5"}) {
    const Model model = expect_unit_cube(write("c.obj", cube_vertices_obj(colour) + f));
    ASSERT_TRUE(model.appearance) << colour;
  }
}

TEST_F(ReadObj, LeavesOutCoordinatesAndNormalsThatAreNotThere) {
  const std::string v = cube_vertices_obj();
  expect_cube(v + kNormals + cube_faces_obj("//1"));
  expect_cube(v + kNormals + cube_faces_obj("/"));
  expect_cube(v + kNormals + cube_faces_obj("/#/1"), {"that are not there: 24"});
  expect_cube(v + kNormals + cube_faces_obj("/1"), {"that are not there: 24"});
  expect_cube(v + cube_faces_obj("//3"), {"that are not there: 24"});
  expect_cube(v + "vt 0 0\n" + cube_faces_obj("/9/-1"), {"that are not there: 48"});
  expect_cube(v + "vt x\nvn 1 y\n" + cube_faces_obj(), {"that cannot be read: 1"});
}

TEST_F(ReadObj, TakesNegativeIdsAndContinuedLines) {
  std::string backwards = cube_vertices_obj();
  for (const auto& q : testing::kCubeSquares) {
    backwards += "f";
    for (const int v : q) backwards += " " + std::to_string(v - 8);
    backwards += "\n";
  }
  expect_cube(backwards);
  expect_cube(replaced(cube_obj(), " 0.5", " \\\n0.5"));
  expect_cube(replaced(cube_obj(), " 0.5", " \\ \r\n0.5"));
  expect_cube(cube_vertices_obj() + replaced(cube_faces_obj(), " ", " \\\n "));
}

TEST_F(ReadObj, TakesNumbersOfOtherPrograms) {
  const std::string v = cube_vertices_obj(), f = cube_faces_obj();
  for (const auto& [from, to] :
       {std::pair("0.5", ".5"), std::pair("0.5", "+.5"), std::pair("0.5", "5D-1"),
        std::pair("0.5", "0.05d+1"), std::pair("0.5", "5.0E-01"), std::pair("0.5", "0.500000")}) {
    const std::string text = replaced(replaced(v, from, to), "-+", "-") + f;
    expect_cube(text);
  }
  expect_cube("v 1e-999 9 9\n" + v + replaced(f, "f ", "f -1 ").substr(0, 0) + [&] {
    std::string moved;
    for (const auto& q : testing::kCubeSquares) {
      moved += "f";
      for (const int k : q) moved += " " + std::to_string(k + 2);
      moved += "\n";
    }
    return moved;
  }());
}

TEST_F(ReadObj, NamesTheLineOfWhatItRefuses) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expect_refused(v + "f 1 2 4\n", {"line 4", "vertex 4", "out of range", "1 to 3"});
  expect_refused(v + "f 1 2 -4\n", {"line 4", "vertex -4", "out of range"});
  expect_refused(v + "\nf 1 2 0\n", {"line 5", "vertex 0", "out of range"});
  expect_refused(v + "f 1 2 x\n", {"line 4", "\"x\"", "7/1/3"});
  expect_refused(v + "f 1 2 3/1/2/4\n", {"line 4", "not a corner"});
  expect_refused(v + "f 1 2 99999999999\n", {"line 4", "out of range"});
  expect_refused("v 0 0\n" + v, {"line 1", "2 numbers", "3 at least"});
  expect_refused("v 0 0,5 0\n" + v, {"line 1", "\"0,5\" is not a number"});
  for (const char* number : {"nan", "-nan", "NaN", "inf", "-Infinity", "1.#QNAN", "1e999"})
    expect_refused("v 0 0 0\nv 1 0 0\nv 0 1 " + std::string(number) + "\nf 1 2 3\n",
                   {"line 3: vertex 2 (0, 1, ", "not finite"});
}

TEST_F(ReadObj, CountsWhatItLeavesOut) {
  const std::string more =
      "l 1 2 3\np 1\nf 1 2\nf 1\nf\nvp 1 2\ncstype bezier\ndeg 3\ncurv 0 1 1 2\nparm u 0 1\nend\n"
      "call a.obj\nhello world\ns off\nlod 1\nusemtl red\n";
  const Model model = read_model(write("a.obj", cube_obj() + more));
  EXPECT_EQ(model.mesh.triangles.size(), 12u);
  expect_parts(joined_notes(model),
               {"lines left out: 2\n", "points left out: 3\n", "free-form surfaces left out: 1\n",
                "commands to other programs left out: 1\n",
                "lines of unknown kinds left out, the first line 27, \"hello\": 1\n"});
  expect_cube("usemtl red\n" + cube_obj(), {"the material \"red\", which no .mtl file has"});
}

TEST_F(ReadObj, FindsLibrariesByWordsOrAsAWhole) {
  write("a.mtl", "newmtl red\nKd 1 0 0\n");
  write("my blue.mtl", "newmtl blue\nKd 0 0 1\n");
  std::filesystem::create_directory(path("sub"));
  write("sub/c.mtl", utf16("newmtl green\r\nKd 0 1 0\r\n", false, true));
  const auto material = [&](const std::string& lines, const std::string& name) {
    const Model model = expect_unit_cube(
        write("m.obj", lines + cube_vertices_obj() + "usemtl " + name + "\n" + cube_faces_obj()));
    return model.materials[model.face_material[0]].base_colour;
  };
  using Colour = std::array<float, 4>;
  EXPECT_EQ(material("mtllib my blue.mtl\n", "blue"), (Colour{0, 0, 1, 1}));
  EXPECT_EQ(material("mtllib a.mtl sub/c.mtl\n", "green"), (Colour{0, 1, 0, 1}));
  EXPECT_EQ(material("mtllib a.mtl\nmtllib sub\\c.mtl\n", "red"), (Colour{1, 0, 0, 1}));
  EXPECT_EQ(material("mtllib \"my blue.mtl\"\n", "blue # a comment"), (Colour{0, 0, 1, 1}));
  EXPECT_EQ(material("mtllib ./a.mtl\n", "  red  "), (Colour{1, 0, 0, 1}));
  expect_cube("mtllib gone.mtl\n" + cube_obj(),
              {"the material file \"gone.mtl\", which is missing"});
  expect_cube("mtllib a.mtl gone.mtl\n" + cube_obj(), {"\"gone.mtl\", which is missing"});
  expect_cube("mtllib gone away.mtl\n" + cube_obj(), {"\"gone away.mtl\", which is missing"});
  expect_cube("mtllib ../../etc/passwd\n" + cube_obj(), {"outside its folder"});
}

TEST_F(ReadObj, LeavesOutUnknownLinesOfMaterials) {
  const auto expect_note = [&](const std::string& lines, const std::vector<std::string>& notes) {
    write("m.mtl", lines);
    expect_cube("mtllib m.mtl\nusemtl m\n" + cube_obj(), notes);
  };
  expect_note("newmtl m\nKd 1 1 1\naniso 0.5\nanisor 0.25\n", {".mtl file: aniso, anisor"});
  expect_note("newmtl m\nKd\n  Ns x\nTr\n", {".mtl file: Kd, Ns, Tr"});
  expect_note("aniso 1\nnewmtl m\nPcr 0\nKa 0 0 0\nillum 2\n# end\n", {".mtl file: aniso"});
  expect_note("newmtl m\nKd spectral x.rfl 1\n", {"\"spectral\""});
  expect_note("\xef\xbb\xbfnewmtl m\r\nKd 1 1 1\r\nNi 1.45\r\n", {});
  expect_note("newmtl m\nbump b.png\nrefl -type sphere r.png\n", {"bump maps", "reflection maps"});
}

TEST_F(ReadObj, FindsTexturesBesideTheirMaterials) {
  for (const char* folder : {"sub", "sub/deep", "textures"})
    std::filesystem::create_directories(path(folder));
  write("sub/a.png", kImage), write("sub/deep/b c.png", kImage), write("textures/d.png", kImage);
  const std::string v = cube_vertices_obj() + "vt 0 0\n", f = cube_faces_obj("/1");
  for (const char* line :
       {"map_Kd a.png", "map_Kd deep/b c.png", "map_Kd deep\\b c.png", "map_Kd d.png",
        "map_Kd C:\\work\\a.png", "map_Kd -s 2 2 -o 0.5 0 0 -clamp on -bm 0.5 a.png",
        "map_kd -blendu on -mm 0 1 -imfchan r deep/b c.png", "\tmap_Kd \"a.png\" "}) {
    write("sub/m.mtl", "newmtl m\n" + std::string(line) + "\n");
    const Model model = read_model(write("t.obj", "mtllib sub/m.mtl\nusemtl m\n" + v + f));
    ASSERT_TRUE(model.appearance) << line;
    EXPECT_EQ(count(*model.appearance).images, 1u) << line << joined_notes(model);
  }
  write("sub/m.mtl", "newmtl m\nmap_Kd gone.png\n");
  expect_cube("mtllib sub/m.mtl\nusemtl m\n" + v + f, {"the texture \"gone.png\", missing"});
}

// The file's digits, not those of float32.
TEST_F(ReadObj, ReadsInDouble) {
  for (const double at : {500000.0, 5e6, -123456789.0}) {
    std::string text;
    for (int i = 0; i < 8; ++i) {
      const Vec3 p = testing::cube_corner(i) * 0.1;
      char line[128];
      std::snprintf(line, sizeof line, "v %.6f %.6f %.6f\n", at + p.x(), at / 10 + p.y(), p.z());
      text += line;
    }
    const Model model = read_model(write("far.obj", text + cube_faces_obj()));
    const Aabb box = model.mesh.box();
    EXPECT_NEAR(box.upper.x() - box.lower.x(), 0.1, std::abs(at) * 1e-15);
    EXPECT_NEAR(testing::mass_of(model).volume, 0.001, 1e-10);
    EXPECT_EQ(model.mesh.vertices.size(), 8u);
  }
}

TEST_F(ReadObj, CutsConcavePolygonsWithoutOverlap) {
  const std::string ends = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n";
  std::string faces = "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
  for (int i = 0; i < 6; ++i)
    faces += "f " + std::to_string(i + 1) + " " + std::to_string((i + 1) % 6 + 1) + " " +
             std::to_string((i + 1) % 6 + 7) + " " + std::to_string(i + 7) + "\n";
  const Model model = read_model(write("l.obj", ends + replaced(ends, " 0\n", " 1\n") + faces));
  EXPECT_EQ(model.mesh.triangles.size(), 20u);
  const MassProperties mass = testing::mass_of(model);
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_DOUBLE_EQ(mass.area, 14);
  EXPECT_DOUBLE_EQ(mass.volume, 3);
  EXPECT_LT((mass.centre - Vec3(5.0 / 6, 5.0 / 6, 0.5)).norm(), 1e-14);
}

}  // namespace
}  // namespace trivet
