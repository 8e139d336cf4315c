// STL and PLY as programs write them: each form is the same unit cube, or says what it is not.
#include <cstring>

#include "core/io/cubes.h"
#include "core/io/look.h"

namespace trivet {
namespace {

using testing::cube_obj;
using testing::cube_ply;
using testing::cube_stl;
using testing::cube_stl_binary;
using testing::error_of;
using testing::expect_parts;
using testing::expect_unit_cube;
using testing::joined_notes;
using testing::replaced;
using testing::utf16;

class ReadStl : public testing::IoTest {};
class ReadPly : public testing::IoTest {};
class ReadByContent : public testing::IoTest {};

std::string capitals(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

TEST_F(ReadStl, TakesTextInAnyForm) {
  for (const std::string& text :
       {cube_stl(), capitals(cube_stl()), replaced(cube_stl(), "\n", "\r\n"),
        replaced(cube_stl(), "\n", "\r"), "\n \n\t" + cube_stl(), "\xef\xbb\xbf" + cube_stl(),
        utf16(cube_stl(), false, true), utf16(cube_stl(), true, true),
        replaced(cube_stl(), "solid cube", "solid"), replaced(cube_stl(), "  ", "\t"),
        replaced(cube_stl(), "0.5", "5D-1"),
        replaced(cube_stl(), "normal 0 0 0", "normal nan nan nan"),
        replaced(cube_stl(), "solid cube", "solid \xe9t\xe9"), cube_stl() + "\n\n",
        replaced(cube_stl(), "vertex", "\nvertex"), "SOLID facet\n" + cube_stl().substr(11)}) {
    SCOPED_TRACE(text.substr(0, 200));
    expect_unit_cube(write("a.stl", text));
  }
}

TEST_F(ReadStl, CountsBytesBehindBinaryTriangles) {
  expect_unit_cube(write("a.stl", cube_stl_binary()));
  expect_unit_cube(write("b.stl", cube_stl_binary("solid cube\nfacet normal")));
  expect_unit_cube(write("c.stl", cube_stl_binary("\xff\xfe")));
  for (const size_t more : {1u, 2u, 49u, 1000u})
    expect_unit_cube(write("d.stl", cube_stl_binary("solid") + std::string(more, '\0')),
                     {"bytes behind the triangles left out: " + std::to_string(more)});
  for (const std::uint32_t count : {0u, 0xffffffffu}) {
    std::string bytes = cube_stl_binary();
    std::memcpy(bytes.data() + 80, &count, 4);
    expect_unit_cube(write("e.stl", bytes), {"not stated", "12"});
  }
}

TEST_F(ReadStl, RefusesWhatIsTruncated) {
  const std::string bytes = cube_stl_binary(), text = cube_stl();
  for (const size_t size : {size_t{83}, size_t{84}, size_t{100}, bytes.size() - 1})
    expect_parts(error_of([&] { read_model(write("a.stl", bytes.substr(0, size))); }), {"a.stl"});
  expect_parts(error_of([&] { read_model(write("b.stl", bytes.substr(0, bytes.size() - 1))); }),
               {"truncated", "11 of 12 triangles"});
  expect_parts(error_of([&] { read_model(write("c.stl", text.substr(0, text.find("0.5")))); }),
               {"line 4", "number"});
  const Model model = read_model(write("d.stl", text.substr(0, text.rfind("endloop"))));
  EXPECT_EQ(model.mesh.triangles.size(), 11u);
  expect_parts(joined_notes(model), {"facets without their end left out: 1"});
}

TEST_F(ReadStl, ReadsColoursOfFacets) {
  std::string bytes = cube_stl_binary();
  for (int f = 0; f < 12; ++f) bytes[84 + 50 * f + 49] = '\xfc';  // valid, red
  ASSERT_TRUE(expect_unit_cube(write("a.stl", bytes)).appearance);
  EXPECT_FALSE(expect_unit_cube(write("b.stl", cube_stl_binary())).appearance);
  std::string magics = cube_stl_binary("COLOR=" + std::string("\xff\0\0\xff", 4));
  ASSERT_TRUE(expect_unit_cube(write("c.stl", magics)).appearance);
}

TEST_F(ReadPly, TakesAllFormatsTypesAndLineEnds) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
    for (const char* type : {"float", "double", "float32", "float64"})
      for (const char* end : {"\n", "\r\n", "\r"}) {
        SCOPED_TRACE(std::string(format) + " " + type);
        expect_unit_cube(write("a.ply", cube_ply(format, type, end)));
      }
  for (const std::string& text :
       {replaced(cube_ply("ascii", "float"), " ", " \t "),
        "\xef\xbb\xbf" + cube_ply("ascii", "float"), utf16(cube_ply("ascii", "float"), false, true),
        capitals(cube_ply("ascii", "float")), replaced(cube_ply("ascii", "float"), "0.5", "5D-1"),
        replaced(cube_ply("ascii", "float"), "\n4 ", "\n4\n"),
        replaced(cube_ply("ascii", "float"), "vertex_indices", "vertex_index")}) {
    SCOPED_TRACE(text);
    expect_unit_cube(write("b.ply", text));
  }
}

// Data may begin with what looks like the end of a line.
TEST_F(ReadPly, TakesAnyFirstByteOfData) {
  for (const char* end : {"\n", "\r\n", "\r"})
    for (const char first : {'\n', '\r', ' ', '\0'}) {
      std::string bytes = cube_ply("binary_little_endian", "float", end);
      const std::string last = "end_header" + std::string(end);
      bytes[bytes.find(last) + last.size()] = first;  // the last bits of a coordinate
      const Model model = read_model(write("a.ply", bytes));
      const MassProperties mass = testing::mass_of(model);
      EXPECT_EQ(mass.rule, MassRule::Volume);
      EXPECT_NEAR(mass.volume, 1, 1e-6);
      EXPECT_EQ(model.mesh.vertices.size(), 8u);
    }
}

TEST_F(ReadPly, ReadsDoublesAsDoubles) {
  const std::string text = cube_ply("ascii", "double");
  const Model near = read_model(write("a.ply", replaced(text, "0.5", "0.05")));
  EXPECT_EQ(near.mesh.box().upper.x(), 0.05);
  const Model far = read_model(write("b.ply", replaced(text, " 0.5", " 5000000.0625")));
  EXPECT_EQ(far.mesh.box().upper.y(), 5000000.0625);
  std::string bytes = cube_ply("binary_little_endian", "double");
  const double tenth = 0.1;  // for the first coordinate
  std::memcpy(bytes.data() + bytes.find("end_header\n") + 11, &tenth, sizeof tenth);
  EXPECT_EQ(read_model(write("c.ply", bytes)).mesh.vertices.size(), 8u);
  bool found = false;
  for (const Vec3& p : read_model(path("c.ply")).mesh.vertices) found |= p.x() == tenth;
  EXPECT_TRUE(found);
}

TEST_F(ReadPly, SkipsAndCountsOtherElements) {
  std::string text = cube_ply("ascii", "float");
  text =
      replaced(text, "element vertex",
               "element camera 2\nproperty list int float view\nproperty double x\nelement vertex");
  text = replaced(text, "end_header\n",
                  "element edge 2\nproperty int vertex1\nproperty int vertex2\n"
                  "end_header\n2 1 2 3\n0 4\n");
  expect_unit_cube(write("a.ply", text + "0 1\n1 2\n"),
                   {"elements \"camera\" left out: 2", "lines left out: 2"});
  for (const char* format : {"binary_little_endian", "binary_big_endian"})
    expect_unit_cube(write("b.ply", cube_ply(format, "double") + "more"),
                     {"bytes behind the data left out: 4"});
  const std::string points = cube_ply("ascii", "float");
  expect_parts(
      error_of([&] {
        read_model(write("c.ply", points.substr(0, points.find("element face")) + "end_header\n" +
                                      points.substr(points.find("\n-0.5") + 1)));
      }),
      {"no triangle", "points left out: 8"});
}

TEST_F(ReadPly, ReadsTriangleStrips) {
  // The cube as one strip, cut once.
  const std::string strip = "0 1 2 3 7 1 5 0 4 2 6 7 4 5";
  std::string text = cube_ply("ascii", "float");
  text = replaced(text.substr(0, text.find("\n4 ") + 1), "element face 6", "element tristrips 1");
  const Model model = read_model(write("a.ply", text + "14 " + strip + "\n"));
  EXPECT_EQ(model.mesh.triangles.size(), 12u);
  const MassProperties mass = testing::mass_of(model);
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_NEAR(mass.volume, 1, 1e-12);
}

TEST_F(ReadPly, RefusesWhatIsNotThere) {
  const auto expect_refused = [&](const std::string& text, const std::vector<std::string>& parts) {
    expect_parts(error_of([&] { read_model(write("b.ply", text)); }), parts);
  };
  const std::string text = cube_ply("ascii", "float");
  expect_refused(replaced(text, "\n4 0", "\n4 8"), {"face", "refers to vertex 8 of 8"});
  expect_refused(replaced(text, "\n4 0", "\n4 -3"), {"face", "refers to vertex -"});
  expect_refused(replaced(text, "\n-0.5", "\nx"), {"\"x\" is not a number", "line 1"});
  expect_refused(replaced(text, "\n-0.5", "\nnan"), {"not finite"});
  expect_refused(replaced(text, "float x", "quad x"), {"line 5", "\"quad\"", "double"});
  expect_refused(replaced(text, "ascii", "binary"), {"line 2", "\"binary\"", "binary_big_endian"});
  expect_refused(replaced(text, "vertex 8", "vertex 80000000"), {"truncated", "80000000"});
}

TEST_F(ReadByContent, TakesWrongNames) {
  for (const char* name : {"a.obj", "a.stl", "a.ply", "a.glb", "a", "A.STL"}) {
    SCOPED_TRACE(name);
    expect_unit_cube(write(name, cube_obj()));
    expect_unit_cube(write(name, cube_stl()));
    expect_unit_cube(write(name, cube_stl_binary()));
    expect_unit_cube(write(name, cube_ply("binary_big_endian", "double")));
  }
}

TEST_F(ReadByContent, NamesWhatIsNoModel) {
  const auto expect_refused = [&](const std::string& name, const std::string& bytes,
                                  const std::string& what) {
    expect_parts(error_of([&] { read_model(write(name, bytes)); }), {name, what});
  };
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 1\n";
  for (const char* name : {"a.glb", "a.obj", "a.fbx", "a.stl", "a.ply", "a.gltf", "a.3mf"}) {
    expect_refused(name, pointer, "Git LFS");
    expect_refused(name, "<!DOCTYPE html>\n<html></html>", "web page");
    expect_refused(name, "\xef\xbb\xbf \n<HTML><head>", "web page");
    expect_refused(name, "\x1f\x8b\x08 packed", "gzip");
  }
}

}  // namespace
}  // namespace trivet
