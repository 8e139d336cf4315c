// Names of objects.
#pragma once

#include <string>

namespace trivet {

/// True if an object may have this name: UTF-8, not empty, no control characters, not "floor".
bool is_object_name(const std::string& name);

}  // namespace trivet
