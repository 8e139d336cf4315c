// Private. seccomp: the system calls that this process may make.
#pragma once

namespace trivet::apps {

/// From now on this process, which must have no_new_privs, makes only the calls that reading a
/// model takes: it opens files for reading, uses what it has open, and its memory; it starts
/// threads, but neither processes nor programs. It has no sockets, maps no code, and signals
/// nobody but itself. All else fails with ENOSYS, as on a system without such calls.
/// @return false: this build or this system has no such filter, and all is as it was.
bool filter_system_calls();

}  // namespace trivet::apps
