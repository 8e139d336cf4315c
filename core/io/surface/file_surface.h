// A surface as a file describes it, in double: what Trivet's own readers have in common.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/io/read_model.h"
#include "core/io/surface/file_material.h"
#include "core/motion/pose.h"

namespace trivet {

/// Ids into the lists of the surface; -1: not given.
struct FileCorner {
  Index position, coordinate = -1, normal = -1, colour = -1;
};

/// Polygons of a node that have the same material.
struct FilePart {
  Index node = 0, material = 0;
};

class FileSurface {
 public:
  std::string path, format;
  std::vector<Vec3> positions;
  std::vector<Eigen::Vector2f> coordinates;  // v runs up
  std::vector<Eigen::Vector3f> normals;      // of any length; zero or not finite: not given
  std::vector<Eigen::Vector4f> colours;      // red, green, blue in sRGB, alpha
  std::vector<FileMaterial> materials;
  std::vector<std::string> nodes;  // names
  UpAxis up = UpAxis::Z;
  bool up_from_format = false;
  std::optional<double> metres_per_unit;
  std::vector<Sentence> notes;
  std::map<Index, Sentence> places;  // of odd positions: "line 12"
  std::vector<FileCorner> corners;   // of all polygons, one after another

  /// The corners added since the last one are a polygon. Fewer than three are none: false.
  bool end_polygon(Index node, Index material);
  size_t num_polygons() const { return m_part_of.size(); }
  std::span<const FileCorner> polygon(size_t i) const {
    return {corners.data() + m_first[i], corners.data() + m_first[i + 1]};
  }
  const std::vector<FilePart>& parts() const { return m_parts; }
  Index part_of(size_t polygon) const { return m_part_of[polygon]; }

 private:
  std::vector<size_t> m_first{0};
  std::vector<Index> m_part_of;
  std::vector<FilePart> m_parts;  // in the order of their first polygons
  std::map<std::pair<Index, Index>, Index> m_part_ids;
  Index m_last_part = -1;
};

/// Adds "what: count" to the notes if there are any.
void note_count(std::vector<Sentence>& notes, const Sentence& what, std::int64_t count);

/// Triangles of the surface by nodes and their materials, in the order of their first polygons.
/// Polygons are cut without overlap (core/exact/triangulate.h).
/// @throws Error (BadInput) naming the file: no triangle, more than the limit, a corner beyond the
///   positions, or at one that is not finite or beyond 1e30.
Model model_of_surface(FileSurface surface, const ImportLimits& limits);

}  // namespace trivet
