// 3MF: a ZIP archive with models as XML.
#pragma once

#include "core/io/surface/file_surface.h"

namespace trivet {

/// True if the first bytes of an archive name a model of 3MF.
bool holds_3mf(std::string_view head);

/// The items of the build with their transforms, components included, each a node; the objects
/// that are no part of another where the build is empty. Colours of triangles are those of base
/// materials and colour groups; other properties, slices and lattices are counted in the notes.
/// @throws Error (BadInput) naming the file: no archive, no model, broken XML, a reference that
///   leads nowhere, an extension that is required and not known.
FileSurface read_3mf(const std::string& path, std::string_view bytes, const ImportLimits& limits);

}  // namespace trivet
