// Output of `trivet info`, as text and as JSON.
#pragma once

#include <optional>
#include <string>

#include "core/index/shape.h"
#include "core/model/model.h"

namespace trivet {

/// Connectivity of a mesh. Faces with two equal corners have fewer edges.
struct Topology {
  std::int64_t num_edges = 0;
  std::int64_t boundary_edges = 0;      // at one face
  std::int64_t non_manifold_edges = 0;  // at more than two faces
  std::int64_t flipped_edges = 0;       // two faces run through it in the same direction
  bool closed = false;    // every edge has an even number of faces: there is an inside
  bool oriented = false;  // every edge is used as often in either direction
  bool manifold = false;  // every edge has one or two faces
};
Topology topology(const Adjacency& adjacency);

/// "m", "cm" or "mm": the largest unit in which the model is at most 3 m long. A guess, for files
/// that state none.
const char* likely_unit(const Aabb& box);

/// The axis along which a model seems to stand: on the plane through its origin, or on the wider
/// foot. A guess, for formats that state none; nullopt: there is no telling. O(vertices).
std::optional<UpAxis> likely_up(const Mesh& mesh);

/// One JSON object; lengths in the file's units.
std::string model_info_json(const Model& model, const Shape& shape);
/// For people: a line per fact.
std::string model_info_text(const Model& model, const Shape& shape);

}  // namespace trivet
