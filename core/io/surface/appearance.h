// Appearance of models that Trivet's own readers read.
#pragma once

#include "core/io/look.h"
#include "core/io/surface/file_surface.h"

namespace trivet {

/// A node for each of the surface's that has triangles, with the model's vertices rounded to
/// float32, relative to export_centre(). Adds notes to `model`.
/// @param triangles  ids of corners, in the order of `part_ends`: a part, and the end of its
///   triangles; parts of a node stand together.
/// @param model  its mesh, materials and normals.
/// @return null if geometry, normals and materials describe the model completely: one node, no
///   texture coordinates, no colours.
std::shared_ptr<const Appearance> appearance_of_surface(
    const FileSurface& surface, const std::vector<Index3>& triangles,
    const std::vector<std::pair<Index, size_t>>& part_ends, const ImportLimits& limits,
    Model& model);

}  // namespace trivet
