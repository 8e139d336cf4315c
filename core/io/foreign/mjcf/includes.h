// Included files of MJCF in place of <include>. Private to the reader.
#pragma once

#include "core/io/foreign/scene_roots.h"
#include "core/io/foreign/xml_text.h"

namespace trivet::mjcf {

/// Reads the main file and all that it includes; a path counts from the main file's folder, else
/// from the including file's. @throws Error (BadInput) as read_xml_tree(); too many files; one
/// outside the roots.
XmlNode read_with_includes(const std::string& path, const XmlLimits& limits,
                           const SceneRoots& roots, std::vector<XmlFile>& files);

}  // namespace trivet::mjcf
