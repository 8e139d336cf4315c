// Unit cubes about the origin as files have them, and what any of them must be read as.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/io/io_testing.h"
#include "core/io/read_model.h"
#include "core/mesh/mass.h"

namespace trivet::testing {

/// Corners: bit k of the number is the side along axis k.
inline Vec3 cube_corner(int i) {
  return {i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5};
}

/// Squares of the cube, counter-clockwise seen from outside, corners from 0.
inline constexpr int kCubeSquares[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

std::string cube_vertices_obj(const std::string& behind = "");
/// Squares; `corner` is written behind each id, `behind` behind each line.
std::string cube_faces_obj(const std::string& corner = "", const std::string& behind = "\n",
                           const std::string& before = "f ");
std::string cube_obj();
std::string cube_stl();
std::string cube_stl_binary(const std::string& header = "");
/// @param format  "ascii", "binary_little_endian" or "binary_big_endian". @param type  of x, y, z.
std::string cube_ply(const std::string& format, const std::string& type,
                     const std::string& line_end = "\n");
/// @param attributes  of the model. @param build  items; "": the object 1.
std::string cube_model_3mf(const std::string& attributes = "", const std::string& build = "",
                           const std::string& resources = "");
/// A ZIP archive of stored entries.
std::string zipped(const std::vector<std::pair<std::string, std::string>>& entries,
                   const std::string& extra = "");
std::string rels_3mf(const std::string& more = "");

/// UTF-16 with or without its byte order mark, of ASCII.
std::string utf16(const std::string& text, bool big_endian, bool marked);

/// Replaces all `from`.
std::string replaced(std::string text, const std::string& from, const std::string& to);

MassProperties mass_of(const Model& model);
std::string joined_notes(const Model& model);

/// Reads it as a closed unit cube, outside out, about the origin.
/// @param notes  parts of the notes; empty: there are none.
Model expect_unit_cube(const std::string& path, const std::vector<std::string>& notes = {});

}  // namespace trivet::testing
