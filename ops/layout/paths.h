// Ways between the files of a scene, which name each other by relative paths.
#pragma once

#include <string>

namespace trivet {

/// "" for a file in the current folder.
std::string folder_of(const std::string& file);
/// The way from a file's folder to another folder; "" for the same one.
std::string folder_from(const std::string& from_file, const std::string& to_folder);

}  // namespace trivet
