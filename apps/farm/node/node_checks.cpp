#include "apps/farm/node/node_checks.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>

#include "apps/farm/store/publish.h"
#include "core/base/error.h"
#include "core/io/process/sandboxed_import.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;
using Verdict = NodeCheck::Verdict;

constexpr double kMB = 1e6;
constexpr rlim_t kFewestDescriptors = 64;  // that batches were tested with

std::string in_mb(double bytes) { return std::to_string(std::llround(bytes / kMB)) + " MB"; }

NodeCheck check_importer() {
  const std::string importer = find_importer();
  if (importer.empty())
    return {"importer", Verdict::Lacking,
            "trivet-import is not beside the program; reinstall it, or name it in TRIVET_IMPORTER"};
  if (access(importer.c_str(), X_OK) != 0)
    return {"importer", Verdict::Lacking, importer + " cannot be executed"};
  return {"importer", Verdict::Ok, importer};
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

NodeCheck check_protection(const Protection& protection) {
  const std::string parts = joined(parts_of(protection)), lacking = joined(lacking_in(protection));
  return {"sandbox", protection.whole() ? Verdict::Ok : Verdict::Note,
          (parts.empty() ? "limits on time and memory only" : parts) +
              (lacking.empty() ? "" : "; not here: " + lacking)};
}

NodeCheck check_sandbox(const std::string& importer) {
  try {
    if (const auto protection = protection_of(importer)) return check_protection(*protection);
  } catch (const Error& e) {
    return {"sandbox", Verdict::Note, e.what()};
  }
  return {"sandbox", Verdict::Note, importer + " does not say what confines it"};
}

// Number in a line such as "MemAvailable:   123 kB"; nullopt: there is none.
std::optional<double> memory_available() {
  std::ifstream file("/proc/meminfo");
  std::string word;
  double kb = 0;
  while (file >> word)
    if (word == "MemAvailable:" && file >> kb) return kb * 1024;
  return std::nullopt;
}

std::optional<double> number_in(const std::string& file) {
  double out = 0;
  std::ifstream in(file);
  if (!(in >> out)) return std::nullopt;  // "max": no limit
  return out;
}

// Left of the cgroup's limit, version 2 or 1, as a container sees its own.
std::optional<double> cgroup_left() {
  constexpr const char* kFiles[][2] = {
      {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"},
      {"/sys/fs/cgroup/memory/memory.limit_in_bytes",
       "/sys/fs/cgroup/memory/memory.usage_in_bytes"}};
  for (const auto& [limit_file, used_file] : kFiles) {
    const auto limit = number_in(limit_file), used = number_in(used_file);
    if (limit && used) return *limit - *used;
  }
  return std::nullopt;
}

NodeCheck check_memory(double needed_mb) {
  const auto available = memory_available(), left = cgroup_left();
  if (!available && !left)
    return {"memory", Verdict::Note, "/proc/meminfo does not tell how much is available"};
  const double bytes = std::min(available.value_or(std::numeric_limits<double>::infinity()),
                                left.value_or(std::numeric_limits<double>::infinity()));
  return {"memory", bytes < needed_mb * kMB ? Verdict::Lacking : Verdict::Ok,
          in_mb(bytes) + " available, " + in_mb(needed_mb * kMB) + " needed (--memory-mb)"};
}

NodeCheck check_descriptors() {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  return {"files", limit.rlim_cur < kFewestDescriptors ? Verdict::Lacking : Verdict::Ok,
          std::to_string(limit.rlim_cur) + " may be open, " + std::to_string(kFewestDescriptors) +
              " needed (ulimit -n)"};
}

// A clock behind the program's own file is wrong; scenes do not depend on it, ages of files do.
NodeCheck check_clock() {
  std::error_code failed;
  const auto installed = fs::last_write_time("/proc/self/exe", failed);
  if (!failed && fs::file_time_type::clock::now() < installed)
    return {"clock", Verdict::Note,
            "it is behind the program's own file: what is written now will look old"};
  return {"clock", Verdict::Ok, "not behind the program's own file"};
}

// Writes and publishes a file, as units are.
NodeCheck check_writing(const std::string& out) {
  const std::string probe = temporary_name((fs::path(out) / "doctor").string());
  const std::string linked = probe + ".link";
  try {
    PublishedFile file(probe);
    file.write("trivet doctor\n");
    file.publish();
  } catch (const Error& e) {
    return {"writing", Verdict::Lacking, e.what()};
  }
  std::error_code failed, ignored;
  fs::create_hard_link(probe, linked, failed);
  fs::remove(linked, ignored);
  fs::remove(probe, ignored);
  if (failed)
    return {"writing", Verdict::Note,
            out +
                " has no hard links: units are published by renaming, the first of two counts "
                "where the file system can rename without replacing"};
  return {"writing", Verdict::Ok, out + ": files are whole or not there, the first of two counts"};
}

NodeCheck check_space(const std::string& out, double needed_mb) {
  std::error_code failed;
  const fs::space_info space = fs::space(out, failed);
  if (failed) return {"disk", Verdict::Lacking, out + ": " + failed.message()};
  const auto bytes = static_cast<double>(space.available);
  return {"disk", bytes < needed_mb * kMB ? Verdict::Lacking : Verdict::Ok,
          in_mb(bytes) + " free in " + out + ", " + in_mb(needed_mb * kMB) + " needed (--disk-mb)"};
}

}  // namespace

const char* to_string(NodeCheck::Verdict verdict) {
  switch (verdict) {
    case Verdict::Ok:
      return "ok";
    case Verdict::Note:
      return "note";
    case Verdict::Lacking:
      return "lacking";
  }
  return "?";
}

std::vector<NodeCheck> check_node(const NodeNeeds& needs) {
  std::vector<NodeCheck> out = {check_importer()};
  if (out.front().verdict == Verdict::Ok) out.push_back(check_sandbox(find_importer()));
  for (const NodeCheck& check : {check_memory(needs.memory_mb), check_descriptors(), check_clock()})
    out.push_back(check);
  if (needs.out.empty()) return out;
  if (!fs::is_directory(needs.out)) {
    out.push_back({"folder", Verdict::Lacking, needs.out + " is no folder"});
    return out;
  }
  out.push_back(check_writing(needs.out));
  out.push_back(check_space(needs.out, needs.disk_mb));
  return out;
}

}  // namespace trivet::farm
