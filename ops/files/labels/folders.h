// Folders and file names of data sets. Private.
#pragma once

#include <string>

namespace trivet {

/// With those above it; it may be there. @throws Error (Environment) naming it.
void make_folder(const std::string& path);
/// 000017
std::string number_text(int number);

}  // namespace trivet
