// Private. What this process may do by its user.
#pragma once

#include <string>

namespace trivet::apps {

/// Gives up every capability, and root: it becomes the user "nobody", which keeps the capability of
/// reading what root may read. Where nobody cannot read the model even so (file systems that let in
/// only who mounted them), it stays root without capabilities.
/// @param model  the file that must stay readable.
/// @return false: capabilities are left.
bool drop_privileges(const std::string& model);

}  // namespace trivet::apps
