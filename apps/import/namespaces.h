// Private. Namespaces: a network and mounts of this process's own.
#pragma once

#include "core/io/process/protection.h"

namespace trivet::apps {

/// Gives this process, which must have one thread, a network without interfaces, and its own view
/// of the file systems, all read-only, without programs and devices: where it may do so, as root or
/// in a user namespace. What it has open stays open. Sets the parts of the protection that hold.
void enter_namespaces(Protection& protection);

}  // namespace trivet::apps
