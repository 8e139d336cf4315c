#include "apps/import/privileges.h"

#include <fcntl.h>
#include <grp.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

#include "core/io/process/local_sockets.h"

namespace trivet::apps {
namespace {

constexpr unsigned kNobody = 65534;

// One bit for each capability; the C library has no functions for them.
struct Capabilities {
  std::uint64_t permitted = 0, effective = 0;
};

__user_cap_header_struct header() { return {_LINUX_CAPABILITY_VERSION_3, 0}; }

Capabilities own_capabilities() {
  auto of = header();
  __user_cap_data_struct halves[2] = {};
  if (syscall(SYS_capget, &of, halves) != 0) return {};
  return {halves[0].permitted | std::uint64_t{halves[1].permitted} << 32,
          halves[0].effective | std::uint64_t{halves[1].effective} << 32};
}

bool set_capabilities(const Capabilities& all) {
  auto of = header();
  __user_cap_data_struct halves[2] = {};
  for (int half = 0; half < 2; ++half) {
    halves[half].permitted = static_cast<std::uint32_t>(all.permitted >> 32 * half);
    halves[half].effective = static_cast<std::uint32_t>(all.effective >> 32 * half);
  }
  return syscall(SYS_capset, &of, halves) == 0;
}

// The capability of reading any file, or if root lacks it (as in containers) that of opening any.
std::uint64_t reading_capability(const Capabilities& all) {
  for (const int capability : {CAP_DAC_READ_SEARCH, CAP_DAC_OVERRIDE})
    if (const std::uint64_t bit = std::uint64_t{1} << capability; all.permitted & bit) return bit;
  return 0;
}

bool is_readable(const std::string& file) {
  return Descriptor(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)).number() >= 0;
}

// Where root may not leave them, they stay.
void leave_groups() {
  if (setgroups(0, nullptr) != 0) return;
  [[maybe_unused]] const int left = setresgid(kNobody, kNobody, kNobody);
}

// Root stays the saved user until the model could be read by nobody.
void become_nobody(const std::string& model, const Capabilities& all, std::uint64_t reading) {
  if (reading == 0 || setresuid(kNobody, kNobody, 0) != 0) return;
  set_capabilities({all.permitted, reading});
  const bool readable = is_readable(model);
  set_capabilities({all.permitted, all.permitted});
  const unsigned user = readable ? kNobody : 0;
  if (readable) leave_groups();
  prctl(PR_SET_KEEPCAPS, 1);
  if (setresuid(user, user, user) != 0) _exit(1);
}

}  // namespace

bool drop_privileges(const std::string& model) {
  if (geteuid() != 0) return set_capabilities({});
  const Capabilities all = own_capabilities();
  const std::uint64_t reading = reading_capability(all);
  become_nobody(model, all, reading);
  return set_capabilities({reading, reading});
}

}  // namespace trivet::apps
