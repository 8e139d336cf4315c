// Errors of bad input.
#pragma once

#include <string>

#include "core/base/error.h"

namespace trivet {

[[noreturn]] inline void bad_input(const std::string& message) {
  throw Error(Error::Kind::BadInput, message);
}

/// "path: reason".
[[noreturn]] inline void bad_file(const std::string& path, const std::string& reason) {
  bad_input(path + ": " + reason);
}

}  // namespace trivet
