// Files that are replaced whole.
#pragma once

#include <functional>
#include <string>

namespace trivet {

/// Writes bytes atomically: temporary file in the same folder, fsync, rename.
/// @throws Error: BadInput where a model that was read consists of this file (note_opened());
///   Environment naming the path and the system's reason. No partial output is left.
void write_file_atomically(const std::string& path, const std::string& bytes);
/// The same for content too large for memory: `content` passes it on piece by piece.
using ByteSink = std::function<void(const std::string& bytes)>;
using FileContent = std::function<void(const ByteSink& write)>;
void write_file_atomically(const std::string& path, const FileContent& content);
/// The same for the bytes of another file; see StagedFiles::add_copy().
void copy_file_atomically(const std::string& from, const std::string& to);

}  // namespace trivet
