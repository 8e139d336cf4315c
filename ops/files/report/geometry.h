// A model's triangles in a scene file, and back to the same bits.
//
// A .glb holds float32 positions, about a centre when the model lies far from its origin, and its
// triangles in groups by material. Most models are float32 from the start, so that nothing is lost
// but the order of the triangles, and that is recorded. Models with scaled or turned nodes have
// doubles that float32 cannot hold; a fingerprint tells them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/read_model.h"
#include "core/model/model.h"

namespace trivet {

/// Data needed to restore a model from a scene file.
struct StoredGeometry {
  std::int64_t num_triangles = 0;
  std::string fingerprint;         // of the model's triangles, in double
  std::string stored_fingerprint;  // of the triangles read back; the same when nothing is lost
  Vec3 centre = Vec3::Zero();      // origin of the file's positions
  // The file has the model's own nodes: positions are those of the model's file, and come back to
  // the bit in its order; `centre` is a node's.
  bool own_nodes = false;
  // Runs of (group of equal material, number of triangles) in the model's order; empty: the file
  // has the model's order.
  std::vector<std::array<std::int64_t, 2>> face_order;
};

/// Hash of all corners in the order of the triangles; -0 counts as 0. Not proof against malice.
std::string geometry_fingerprint(const Mesh& mesh);

StoredGeometry stored_geometry(const Model& model);

/// The models of a scene file as Trivet wrote it, in their mesh's coordinates and the file's order
/// of triangles, one for each pair of a node's name and what is known about its model.
/// @throws Error (BadInput) when nodes are missing or have other numbers of triangles.
std::vector<Model> read_node_models(
    const std::string& path, const std::vector<std::pair<std::string, StoredGeometry>>& nodes,
    const ImportLimits& limits);

/// The model in its own order and about its own origin. An order that does not fit is left alone:
/// the fingerprint shows it.
Model restored(Model model, const StoredGeometry& stored);

}  // namespace trivet
