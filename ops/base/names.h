// Names of objects.
#pragma once

#include <string>

namespace trivet {

/// Whether an object may be called that: UTF-8, not empty, no control characters, not "floor".
bool is_object_name(const std::string& name);

}  // namespace trivet
