// Serialisation of models between processes of the same program.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/sentence.h"
#include "core/io/read_model.h"
#include "core/model/model.h"

namespace trivet {

std::string bytes_of_model(const Model& model);
std::string bytes_of_error(Error::Kind kind, const Sentence& sentence);

/// Inverse of the functions above. The bytes may come from a compromised process: everything is
/// validated like a file. The model's path is `path`.
/// @throws the Error contained in the bytes; Error (BadInput) if they hold neither model nor error.
Model model_from_bytes(std::string_view bytes, const std::string& path, const ImportLimits& limits);

}  // namespace trivet
