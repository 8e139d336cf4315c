// Files that models consist of, as those who opened them report. Nothing may overwrite them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace trivet {

/// Notes that reading `model` opened these files beside it, or that it names them: materials,
/// textures, buffers. Those that are not there, and the model itself, are left out. Kept as long as
/// the process lives, by what the files are, whatever they are called. Thread-safe.
void note_opened(const std::string& model, const std::vector<std::string>& files);

/// The files that were noted for a model, as they were called; nullopt: it was not read.
std::optional<std::vector<std::string>> files_opened_for(const std::string& model);

/// The model, as it was called, that this file belongs to; of several the first. Empty: none.
/// @param but  models that count as none: one that is to be replaced owns its files.
std::string model_that_opened(const std::string& file, const std::string& but = {});

}  // namespace trivet
