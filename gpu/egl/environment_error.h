// Private to gpu.
#pragma once

#include <string>

#include "core/base/error.h"

namespace trivet {

inline Error environment_error(const std::string& message) {
  return {Error::Kind::Environment, message};
}

}  // namespace trivet
