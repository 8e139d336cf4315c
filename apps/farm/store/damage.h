// Values of files that Trivet wrote, and that may have been damaged since.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/base/bad_input.h"

namespace trivet::farm {

/// The result of `read`, which takes values out of JSON as they were written.
/// @throws Error (BadInput) naming the place where one is missing, or of another kind.
template <class Read>
auto read_undamaged(const std::string& where, const Read& read) {
  try {
    return read();
  } catch (const nlohmann::json::exception&) {
    bad_file(where, "is damaged: a value is missing, or of another kind");
  }
}

}  // namespace trivet::farm
