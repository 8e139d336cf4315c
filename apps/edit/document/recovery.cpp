#include "apps/edit/document/recovery.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>

#include "apps/edit/document/file_lock.h"
#include "apps/edit/document/layout_paths.h"
#include "core/base/error.h"
#include "ops/session/journal.h"

namespace trivet::edit {
namespace {

namespace fs = std::filesystem;

std::string local_time(fs::file_time_type when) {
  const auto system = std::chrono::file_clock::to_sys(when);
  const std::time_t time = std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(system));
  std::tm parts{};
  localtime_r(&time, &parts);
  char text[32];
  return std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts) > 0 ? text : "";
}

size_t num_steps(const JournalContent& content) {
  return static_cast<size_t>(
      std::count_if(content.records.begin(), content.records.end(),
                    [](const JournalRecord& r) { return r.kind == JournalRecord::Kind::Step; }));
}

// No step, or none since the last save.
bool is_of_no_use(const JournalContent& content) {
  return num_steps(content) == 0 || content.records.back().kind == JournalRecord::Kind::Saved;
}

// A journal just created by another editor may not be locked yet.
bool is_old(fs::file_time_type when) {
  return fs::file_time_type::clock::now() - when > std::chrono::minutes(1);
}

}  // namespace

std::vector<Recoverable> recoverable_sessions(const std::string& folder) {
  std::vector<std::pair<fs::file_time_type, Recoverable>> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string journal = entry.path().string();
    if (entry.path().extension() != ".journal" || is_locked(journal)) continue;
    try {
      const JournalContent content = read_journal(journal);
      const auto when = entry.last_write_time();
      if (is_of_no_use(content)) {
        if (is_old(when)) remove_recovery_files(journal);
        continue;
      }
      found.push_back(
          {when, {journal, saved_file_of(journal, content), local_time(when), num_steps(content)}});
    } catch (const Error&) {
      continue;  // damaged: kept for manual repair
    }
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Recoverable> out;
  for (auto& [when, session] : found) out.push_back(std::move(session));
  return out;
}

void discard_session(const std::string& journal) {
  if (!is_locked(journal)) remove_recovery_files(journal);
}

}  // namespace trivet::edit
