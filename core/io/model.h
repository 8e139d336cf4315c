// Models as read from files: triangles for geometry, appearance for pictures and export.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/io/tessellation.h"
#include "core/mesh/mesh.h"
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

/// Everything read from one file. Geometry is exact: float32 positions of the file, node matrices
/// (float32) multiplied in double, row by row.
struct Model {
  std::string path;                  // as given
  std::string format;                // "obj", "gltf2", ... as named by assimp
  Mesh mesh;                         // all triangles of all nodes, object frame
  std::vector<Material> materials;   // at least one
  std::vector<Index> face_material;  // #F
  // #F x 3 corner normals, unit, object frame; empty if the file has none.
  std::vector<std::array<Eigen::Vector3f, 3>> corner_normals;
  UpAxis up = UpAxis::Z;                  // stated by the format, else z
  bool up_from_format = false;            // stated by the format or the file
  std::optional<double> metres_per_unit;  // stated by the file, if any (reported, not applied)
  std::vector<std::string> notes;  // contents noticed and left out: lines, points, empty nodes
  int num_nodes = 0;
  // Hierarchy, texture coordinates, textures, cameras, lights, for export to glTF. Null if the
  // members above are complete.
  std::shared_ptr<const Appearance> appearance;
  // For formats with curved surfaces: requested tessellation, and the result at import.
  Tessellation tessellation;
  std::optional<Polygonisation> polygonised;
};

/// Limits for untrusted files. The last three apply to import_model() (sandboxed_import.h).
struct ImportLimits {
  std::uintmax_t max_file_bytes = std::uintmax_t{4} << 30;
  std::int64_t max_triangles = 50'000'000;
  // Program trivet-import; empty: import in this process. Builds with Open CASCADE have
  // trivet-import-cad beside it, for STEP, IGES and BREP.
  std::string importer;
  double max_seconds = 0;               // 0: 60, plus one for each MB of the file
  std::uintmax_t max_memory_bytes = 0;  // 0: 1 GiB plus 64 times the file's size
};

/// Reads a model with assimp. Polygons are triangulated; points and lines are left out and noted.
/// STEP, IGES and BREP need import_model().
/// @throws Error (BadInput) naming the file: missing, unreadable, empty, no triangle, coordinates
///   that are not finite (or beyond 1e30), index out of range, larger than the limits.
Model read_model(const std::string& path, const ImportLimits& limits = {});

}  // namespace trivet
