// Objects of a model part of 3MF. Private to the reader.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/io/read_model.h"
#include "core/io/surface/file_material.h"
#include "core/io/text/xml_reader.h"

namespace trivet::threemf {

/// A part of the archive and an id in it.
using ObjectKey = std::pair<std::string, std::string>;

struct Component {
  ObjectKey object;
  Affine parent_from_object;
};

struct Triangle3 {
  Index3 vertices;
  Index material = -1;  // -1: of the object
};

struct MeshObject {
  std::string name;
  bool is_support = false;
  std::vector<Vec3> vertices;
  std::vector<Triangle3> triangles;
  std::vector<Component> components;
  Index material = -1;  // -1: none
};

/// All model parts of an archive.
struct Document {
  double metres_per_unit = 0.001;
  std::map<ObjectKey, MeshObject> objects;
  std::vector<ObjectKey> order;  // of the objects, in the root part
  std::vector<Component> items;  // of the build of the root part
  std::vector<FileMaterial> materials;
  std::vector<Sentence> notes;
};

/// Reads a part, in UTF-8 or UTF-16. The root part has the unit and the build.
/// @throws Error (BadInput) naming the file, the part and the element.
void read_model_part(const std::string& file, const std::string& part, const std::string& xml,
                     bool is_root, const ImportLimits& limits, Document& document);

/// read_xml() of a part.
/// @throws Error (BadInput) naming the file, the part and the line: not well formed.
void read_xml_part(const std::string& file, const std::string& part, std::string_view xml,
                   const XmlHandlers& handlers);

}  // namespace trivet::threemf
