// OFF as programs write it: each form is the same unit cube, or says what it is not.
#include "core/io/cubes.h"
#include "core/io/look.h"

namespace trivet {
namespace {

using testing::error_of;
using testing::expect_parts;
using testing::expect_unit_cube;
using testing::replaced;
using testing::utf16;

class ReadOff : public testing::IoTest {};

/// @param vertex, face  behind each line of them.
std::string cube_off(const std::string& head = "OFF\n8 6 12\n", const std::string& vertex = "",
                     const std::string& face = "") {
  std::string out = head;
  for (int i = 0; i < 8; ++i) {
    const Vec3 p = testing::cube_corner(i);
    for (int k = 0; k < 3; ++k) out += (p[k] > 0 ? "0.5 " : "-0.5 ");
    out += vertex + "\n";
  }
  for (const auto& square : testing::kCubeSquares) {
    out += "4";
    for (const int v : square) out += " " + std::to_string(v);
    out += face + "\n";
  }
  return out;
}

TEST_F(ReadOff, TakesAnyForm) {
  const std::string plain = cube_off();
  for (const std::string& text : {plain,
                                  cube_off("OFF 8 6 12\n"),
                                  cube_off("off\n8 6\n"),
                                  cube_off("OFF\n8\n6\n\n12 # edges\n"),
                                  cube_off("# made by hand\n\nOFF # text\n 8  6\t12 # counts\n"),
                                  replaced(plain, "\n", "\r\n"),
                                  replaced(plain, "\n", "\r"),
                                  replaced(plain, " ", "\t"),
                                  replaced(plain, "\n", "\n\n "),
                                  plain.substr(0, plain.size() - 1),
                                  "\xef\xbb\xbf" + plain,
                                  utf16(plain, false, true),
                                  utf16(plain, true, true),
                                  replaced(plain, "0.5", "5D-1"),
                                  cube_off("OFF\n8 6 0\n", "# v", " # f"),
                                  cube_off("4OFF\n8 6 0\n", "1"),
                                  cube_off("NOFF\n8 6 0\n", "0 0 1"),
                                  cube_off("nOFF\n3\n8 6 0\n"),
                                  cube_off("4nOFF 3\n8 6 0\n", "1"),
                                  cube_off("NnOFF 3\n8 6 0\n", "0 0 1")}) {
    SCOPED_TRACE(text.substr(0, 100));
    expect_unit_cube(write("a.off", text));
    expect_unit_cube(write("a.obj", text));
  }
  expect_unit_cube(write("a.off", cube_off("8 6 12\n")));
  // All numbers on one line.
  expect_unit_cube(write("a.off", "OFF " + replaced(plain.substr(4), "\n", " ")));
}

TEST_F(ReadOff, ReadsColoursOfVerticesAndFaces) {
  for (const std::string& text :
       {cube_off("COFF\n8 6 0\n", "255 0 0 255"), cube_off("OFF\n8 6 0\n", "1 0 0"),
        cube_off("OFF\n8 6 0\n", "", " 255 0 0"),
        cube_off("OFF\n8 6 0\n", "", " 1.0 0.5 0.25 1.0")}) {
    SCOPED_TRACE(text.substr(0, 60));
    const Model model = read_model(write("a.off", text));
    ASSERT_TRUE(model.appearance);
    EXPECT_TRUE(model.notes.empty());
  }
  expect_unit_cube(write("a.off", cube_off("OFF\n8 6 0\n", "", " 7")), {"numbers of a table: 6"});
}

TEST_F(ReadOff, CountsWhatItLeavesOut) {
  const std::string more =
      replaced(cube_off(), "8 6 12", "8 9 12") + "2 0 1\n1 3\n1 4\nend of file\n";
  expect_unit_cube(write("a.off", more), {"points left out: 2", "lines left out: 1",
                                          "words behind the faces left out: 3"});
}

TEST_F(ReadOff, SaysWhatItIsNot) {
  const auto expect_refused = [&](const std::string& text, const std::vector<std::string>& parts) {
    expect_parts(error_of([&] { read_model(write("a.off", text)); }), parts);
  };
  const std::string plain = cube_off();
  expect_refused(plain.substr(0, plain.size() / 2), {"a.off", "is truncated", "of 14"});
  expect_refused("OFF\n", {"is truncated"});
  expect_refused("OFF BINARY\n\x01\x02", {"binary OFF", "accepted: OFF as text"});
  expect_refused("STCN4OFF BINARY\n\x01\x02", {"binary OFF"});
  expect_refused("nOFF 2\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n", {"nOFF", "2 numbers", "accepted: 3"});
  expect_refused("AOFF\n8 6 12\n", {"keyword \"AOFF\"", "accepted: OFF, with ST, C, N, 4 and n"});
  expect_refused(replaced(plain, "4 0 2 3 1", "4 0 2 3 8"), {"line 11", "vertex 8", "0 to 7"});
  expect_refused(replaced(plain, "4 0 2 3 1", "4 0 2 3 -1"), {"line 11", "vertex -1"});
  expect_refused(replaced(plain, "4 0 2 3 1", "4 0 2 3 1.5"), {"vertex 1.5"});
  expect_refused(replaced(plain, "4 0 2 3 1", "-4 0 2 3 1"), {"not a number of"});
  expect_refused(replaced(plain, "8 6 12", "8 99999999999 12"), {"not a number of"});
  expect_refused(replaced(plain, "8 6 12", "8 2000000000 12"), {"is truncated"});
  expect_refused(replaced(plain, "0.5 0.5 0.5", "0.5 nan 0.5"), {"line 10", "not finite"});
  expect_refused(replaced(plain, "0.5 0.5 0.5", "0.5 x 0.5"), {"line 9", "not a number"});
}

// Digits of a survey, moved to an origin of the model's own without rounding.
TEST_F(ReadOff, MovesFarModelsExactly) {
  const std::string far =
      "OFF\n4 4 0\n500000.125 5000000.25 100\n500001.125 5000000.25 100\n"
      "500000.125 5000001.25 100\n500000.125 5000000.25 101\n"
      "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const Model model = read_model(write("a.off", far));
  ASSERT_EQ(model.notes.size(), 1u);
  expect_parts(in_english(model.notes[0]), {"origin of its own", "(500000, 5000000, 100)"});
  const Aabb box = model.mesh.box();
  EXPECT_EQ(box.lower, Vec3(0.125, 0.25, 0));
  EXPECT_EQ(box.upper, Vec3(1.125, 1.25, 1));
}

}  // namespace
}  // namespace trivet
