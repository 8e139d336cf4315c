// Ways between the files of a scene, which name each other by relative paths.
#pragma once

#include <string>
#include <vector>

namespace trivet {

/// "" for a file in the current folder.
std::string folder_of(const std::string& file);
/// The way from a file's folder to another folder; "" for the same one.
std::string folder_from(const std::string& from_file, const std::string& to_folder);

struct Layout;
/// The files that a layout in this folder is made of, each once: its scene first, then the models
/// of its objects and of appended ones.
std::vector<std::string> model_files(const Layout& layout, const std::string& folder);

}  // namespace trivet
