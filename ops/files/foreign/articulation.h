// Cabinets of other programs as objects of a layout: each body an object, each joint a joint.
#pragma once

#include <string>

#include "core/io/read_model.h"
#include "ops/files/layout/layout.h"

namespace trivet {

/// A file in MJCF, URDF or SDF, placed in a layout.
struct PlacedArticulation {
  std::string name;   // its objects are called NAME/BODY
  std::string file;   // path as the layout has it
  Pose pose;          // of the file's frame
  bool fixed = true;  // what hangs in nothing, and the file does not move freely, is fixed
};

/// Adds its bodies to the objects of a layout, and the pairs that never collide. Joints that cannot
/// be moved are held; planes and what does not collide are left out.
/// @param folder  of the layout. @throws Error (BadInput): as open_scene().
void add_articulation(const PlacedArticulation& placed, const std::string& folder, Layout& layout);

/// True for FILE#BODY, the model of one body of such a file.
bool is_link_model(const std::string& path);
/// @param path  of an existing file, #BODY added. @throws Error (BadInput) as open_scene().
Model link_model(const std::string& path, const ImportLimits& limits);

}  // namespace trivet
