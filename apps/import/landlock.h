// Private. Landlock: the files that this process may open.
#pragma once

#include <filesystem>
#include <vector>

namespace trivet::apps {

/// From now on this process, which must have no_new_privs, opens files in these folders and below
/// them for reading, and no others; it changes none, connects to none by TCP, and signals none
/// outside. Needs Linux 5.13 (files), 6.7 (TCP), 6.12 (signals).
/// @return false: the system has no Landlock, and all is as it was.
bool restrict_files(const std::vector<std::filesystem::path>& folders);

}  // namespace trivet::apps
