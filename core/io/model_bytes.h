// A model as bytes, from one process to another of the same program.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/model.h"

namespace trivet {

std::string bytes_of_model(const Model& model);
std::string bytes_of_error(Error::Kind kind, const std::string& message);

/// What one of the above has made, unless it comes from a process that has gone astray: everything
/// is checked as if it were a file. The model's path is `path`.
/// @throws the Error that the bytes hold; Error (BadInput) when they hold neither.
Model model_from_bytes(std::string_view bytes, const std::string& path, const ImportLimits& limits);

}  // namespace trivet
