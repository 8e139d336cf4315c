#include "core/io/cubes.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "support/stored_zip.h"

namespace trivet::testing {
namespace {

template <class T>
void append_value(std::string& out, T value, bool big_endian = false) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (big_endian) std::reverse(bytes, bytes + sizeof value);
  out.append(bytes, sizeof value);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string coordinates(int corner) {
  const Vec3 p = cube_corner(corner);
  return number(p.x()) + " " + number(p.y()) + " " + number(p.z());
}

}  // namespace

std::string cube_vertices_obj(const std::string& behind) {
  std::string out;
  for (int i = 0; i < 8; ++i) out += "v " + coordinates(i) + behind + "\n";
  return out;
}

std::string cube_faces_obj(const std::string& corner, const std::string& behind,
                           const std::string& before) {
  std::string out;
  for (const auto& square : kCubeSquares) {
    out += before;
    for (int k = 0; k < 4; ++k)
      out += (k ? " " : "") + std::to_string(square[k] + 1) +
             replaced(corner, "#", std::to_string(square[k] + 1));
    out += behind;
  }
  return out;
}

std::string cube_obj() { return cube_vertices_obj() + cube_faces_obj(); }

std::string cube_stl() {
  std::string out = "solid cube\n";
  for (const auto& q : kCubeSquares)
    for (const std::array<int, 3> t : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      out += "  facet normal 0 0 0\n    outer loop\n";
      for (const int k : t) out += "      vertex " + coordinates(q[k]) + "\n";
      out += "    endloop\n  endfacet\n";
    }
  return out + "endsolid cube\n";
}

std::string cube_stl_binary(const std::string& header) {
  std::string out = header;
  out.resize(80, '\0');
  append_value(out, std::uint32_t{12});
  for (const auto& q : kCubeSquares)
    for (const std::array<int, 3> t : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      out.append(12, '\0');
      for (const int k : t)
        for (int i = 0; i < 3; ++i) append_value(out, static_cast<float>(cube_corner(q[k])[i]));
      out.append(2, '\0');
    }
  return out;
}

std::string cube_ply(const std::string& format, const std::string& type,
                     const std::string& line_end) {
  std::string out = "ply\nformat " + format + " 1.0\ncomment a cube\nelement vertex 8\nproperty " +
                    type + " x\nproperty " + type + " y\nproperty " + type +
                    " z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
  out = replaced(out, "\n", line_end);
  const bool text = format == "ascii", big = format == "binary_big_endian";
  for (int i = 0; i < 8; ++i) {
    if (text) out += coordinates(i) + line_end;
    for (int k = 0; k < 3 && !text; ++k) {
      const double x = cube_corner(i)[k];
      type == "double" || type == "float64" ? append_value(out, x, big)
                                            : append_value(out, static_cast<float>(x), big);
    }
  }
  for (const auto& q : kCubeSquares) {
    out += text ? "4" : "\4";
    for (const int v : q) text ? void(out += " " + std::to_string(v)) : append_value(out, v, big);
    if (text) out += line_end;
  }
  return out;
}

std::string cube_model_3mf(const std::string& attributes, const std::string& build,
                           const std::string& resources) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model " + attributes +
                    " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">"
                    "<resources>" +
                    resources + "<object id=\"1\" type=\"model\"><mesh><vertices>";
  for (int i = 0; i < 8; ++i) {
    const Vec3 p = cube_corner(i);
    out += "<vertex x=\"" + number(p.x()) + "\" y=\"" + number(p.y()) + "\" z=\"" + number(p.z()) +
           "\"/>";
  }
  out += "</vertices><triangles>";
  for (const auto& q : kCubeSquares)
    for (const std::array<int, 3> t : {std::array{0, 1, 2}, std::array{0, 2, 3}})
      out += "<triangle v1=\"" + std::to_string(q[t[0]]) + "\" v2=\"" + std::to_string(q[t[1]]) +
             "\" v3=\"" + std::to_string(q[t[2]]) + "\"/>";
  out += "</triangles></mesh></object></resources><build>";
  return out + (build.empty() ? "<item objectid=\"1\"/>" : build) + "</build></model>";
}

std::string zipped(const std::vector<std::pair<std::string, std::string>>& entries,
                   const std::string& extra) {
  StoredZip zip;
  for (const auto& [name, content] : entries) zip.add(name, content, extra);
  return zip.bytes();
}

std::string rels_3mf(const std::string& more) {
  return "<?xml version=\"1.0\"?><Relationships xmlns=\"http://schemas.openxmlformats.org/package/"
         "2006/relationships\">" +
         more +
         "<Relationship Target=\"/3D/a.model\" Id=\"r0\" "
         "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
}

std::string utf16(const std::string& text, bool big_endian, bool marked) {
  std::string out;
  if (marked) append_value(out, std::uint16_t{0xfeff}, big_endian);
  for (const char c : text) append_value(out, static_cast<std::uint16_t>(c), big_endian);
  return out;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

MassProperties mass_of(const Model& model) {
  return mass_properties(model.mesh, make_adjacency(model.mesh));
}

std::string joined_notes(const Model& model) {
  std::string out;
  for (const Sentence& note : model.notes) out += in_english(note) + "\n";
  return out;
}

Model expect_unit_cube(const std::string& path, const std::vector<std::string>& notes) {
  Model model;
  try {
    model = read_model(path);
  } catch (const Error& e) {
    ADD_FAILURE() << e.what();
    return model;
  }
  const MassProperties mass = mass_of(model);
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_NEAR(mass.volume, 1, 1e-12);
  EXPECT_NEAR(mass.area, 6, 1e-12);
  EXPECT_LT(mass.centre.norm(), 1e-12);
  EXPECT_EQ(model.mesh.triangles.size(), 12u);
  EXPECT_EQ(model.mesh.vertices.size(), 8u);
  expect_parts(joined_notes(model), notes);
  if (notes.empty()) {
    EXPECT_EQ(joined_notes(model), "");
  }
  return model;
}

}  // namespace trivet::testing
