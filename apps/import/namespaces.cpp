#include "apps/import/namespaces.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace trivet::apps {
namespace {

// The kernel's interface, of Linux 5.12; older C libraries lack it.
constexpr long kSetAttributes = 442;
struct MountAttributes {
  std::uint64_t set, cleared, propagation, user_namespace;
};
constexpr std::uint64_t kReadOnly = 1, kNoSetUser = 2, kNoDevices = 4, kNoPrograms = 8;
constexpr unsigned kAndBelow = 0x8000;

// File systems that others unmount must not stay because of this process: MS_SLAVE.
bool make_mounts_read_only() {
  const MountAttributes attributes{kReadOnly | kNoSetUser | kNoDevices | kNoPrograms, 0, MS_SLAVE,
                                   0};
  return syscall(kSetAttributes, AT_FDCWD, "/", kAndBelow, &attributes, sizeof attributes) == 0;
}

}  // namespace

void enter_namespaces(Protection& protection) {
  constexpr int kOwn = CLONE_NEWNET | CLONE_NEWNS;
  // In a user namespace root could no longer read what belongs to others.
  if (unshare(geteuid() == 0 ? kOwn : kOwn | CLONE_NEWUSER) != 0) return;
  protection.network = true;
  protection.mounts = make_mounts_read_only();
}

}  // namespace trivet::apps
