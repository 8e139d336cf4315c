#include "apps/import/landlock.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

#include "core/io/process/local_sockets.h"

namespace trivet::apps {
namespace {

// The kernel's interface: the C library has no functions, and older systems no header for it. The
// numbers are those of all architectures.
constexpr long kCreateRuleset = 444, kAddRule = 445, kRestrictSelf = 446;
constexpr unsigned kAskVersion = 1;
constexpr int kPathBeneath = 1;
struct RulesetAttributes {
  std::uint64_t files, network, scopes;
};
struct [[gnu::packed]] PathBeneath {
  std::uint64_t access;
  std::int32_t parent;
};
constexpr std::uint64_t kReadFile = 1 << 2, kReadFolder = 1 << 3;

std::uint64_t lowest_bits(int count) { return (std::uint64_t{1} << count) - 1; }

// All that this version of the interface can forbid. `bytes`: the structure's size then.
RulesetAttributes everything(long version, size_t& bytes) {
  const int num_rights = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
  bytes = version >= 6 ? 24 : version >= 4 ? 16 : 8;
  return {lowest_bits(num_rights), version >= 4 ? lowest_bits(2) : 0,
          version >= 6 ? lowest_bits(2) : 0};
}

// One that cannot be opened is none that can be read.
void allow_reading(int ruleset, const std::filesystem::path& folder) {
  const Descriptor opened(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() < 0) return;
  const PathBeneath rule{kReadFile | kReadFolder, opened.number()};
  syscall(kAddRule, ruleset, kPathBeneath, &rule, 0U);
}

}  // namespace

bool restrict_files(const std::vector<std::filesystem::path>& folders) {
  const long version = syscall(kCreateRuleset, nullptr, size_t{0}, kAskVersion);
  if (version < 1) return false;
  size_t bytes = 0;
  const RulesetAttributes attributes = everything(version, bytes);
  const Descriptor ruleset(static_cast<int>(syscall(kCreateRuleset, &attributes, bytes, 0U)));
  if (ruleset.number() < 0) return false;
  for (const std::filesystem::path& folder : folders) allow_reading(ruleset.number(), folder);
  return syscall(kRestrictSelf, ruleset.number(), 0U) == 0;
}

}  // namespace trivet::apps
