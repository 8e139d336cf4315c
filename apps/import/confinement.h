// Parts that confine a program that reads untrusted files, so far as the system has them.
#pragma once

#include <string>

#include "core/io/process/protection.h"

namespace trivet::apps {

/// The part that is entered once, by a process of one thread: no descriptors but the standard ones
/// and `kept`, no new privileges, namespaces.
Protection confine_process(int kept);

/// The part that depends on the model: no files but those in its folder and below, no privileges,
/// few system calls. Cannot be undone.
/// @param protection  of the process so far.   @return with the parts that hold now.
Protection confine_reading(const std::string& model, Protection protection);

}  // namespace trivet::apps
