// Models as read from files: triangles for geometry, appearance for pictures and export.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/mesh/mesh.h"
#include "core/model/tessellation.h"
#include "core/motion/pose.h"

namespace trivet {

/// Surface material; linear RGB.
struct Material {
  std::string name;
  std::array<float, 4> base_colour{0.8f, 0.8f, 0.8f, 1.0f};
  float metallic = 0.0f;
  float roughness = 0.6f;
};

struct Appearance;

/// Everything read from one file. Geometry is exact: positions as the file has them, in double of
/// text and double PLY, else float32, node matrices (float32) multiplied in double, row by row.
struct Model {
  std::string path;                  // as given
  std::string format;                // "obj", "stl", "ply", "3mf", "gltf2", ...
  Mesh mesh;                         // all triangles of all nodes, object frame
  std::vector<Material> materials;   // at least one
  std::vector<Index> face_material;  // #F
  // #F x 3 corner normals, unit, object frame; empty if the file has none.
  std::vector<std::array<Eigen::Vector3f, 3>> corner_normals;
  UpAxis up = UpAxis::Z;                  // stated by the format, else z
  bool up_from_format = false;            // stated by the format or the file
  std::optional<double> metres_per_unit;  // stated by the file, if any (core/model/unit.h)
  std::vector<Sentence> notes;  // contents left out or read otherwise, each counted and named
  int num_nodes = 0;
  // Hierarchy, texture coordinates, textures, cameras, lights, for export to glTF. Null if the
  // members above are complete.
  std::shared_ptr<const Appearance> appearance;
  // The appearance has the vertices rounded to float32, relative to export_centre().
  bool rounded_appearance = false;
  // For formats with curved surfaces: requested tessellation, and the result at import.
  Tessellation tessellation;
  std::optional<Polygonisation> polygonised;
};

}  // namespace trivet
