#include "ops/session/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/io/atomic_file.h"
#include "ops/files/json/operation_json.h"
#include "ops/files/layout/paths.h"
#include "ops/session/journal_text.h"
#include "ops/session/session.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;
constexpr auto kAnySize = std::numeric_limits<std::uintmax_t>::max();

[[noreturn]] void fail(const std::string& path, const Sentence& what, int error) {
  throw Error(Error::Kind::Environment, "%1: %2: %3", path, what, std::strerror(error));
}

// The lines, and how many bytes they are with their ends; what follows the last end is left out.
std::vector<std::string> whole_lines(const std::string& text) {
  std::vector<std::string> lines;
  size_t begin = 0;
  for (size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(text.substr(begin, end - begin));
  return lines;
}

// A second name costs nothing; where that cannot be, a copy.
void keep_start_file(const std::string& start_file, const std::string& copy) {
  std::error_code error;
  if (fs::equivalent(start_file, copy, error)) return;  // it is called that
  fs::remove(copy, error);                              // of a journal that is gone
  fs::create_hard_link(fs::canonical(start_file, error), copy, error);
  if (!error) return;
  write_file_atomically(copy, read_text_file(start_file, kAnySize));
}

}  // namespace

std::string start_copy_of(const std::string& journal) { return journal + ".start"; }

std::string hash_of_file(const std::string& path, std::uintmax_t& bytes) {
  const std::string text = read_text_file(path, kAnySize);
  bytes = text.size();
  return Hash().add(text).text();
}

JournalContent read_journal(const std::string& path) {
  const std::string text = read_text_file(path, kAnySize);
  const std::vector<std::string> lines = whole_lines(text);
  size_t num_valid = 0;
  JournalContent content;
  for (size_t i = 0; i < lines.size(); ++i) {
    const auto json = checked_line(lines[i]);
    if (!json) continue;
    const std::string name = path + ": line " + std::to_string(i + 1);
    if (i != num_valid)
      throw Error(
          Error::Kind::BadInput,
          "%1: line %2 is damaged, and others follow it; accepted: a journal as Trivet wrote it",
          path, num_valid + 1);
    const JsonPlace place(*json, name);
    if (i == 0)
      content.start = read_start(place);
    else
      content.records.push_back(read_record(place));
    content.whole_bytes += lines[i].size() + 1;
    ++num_valid;
  }
  if (num_valid == 0)
    throw Error(Error::Kind::BadInput, "%1: is no journal; accepted: a journal that Trivet wrote",
                path);
  content.all_bytes = text.size();
  return content;
}

Journal::Journal(std::string path, std::uintmax_t size) : m_path(std::move(path)), m_size(size) {
  m_descriptor = ::open(m_path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (m_descriptor < 0) fail(m_path, "the journal cannot be opened", errno);
  if (flock(m_descriptor, LOCK_EX | LOCK_NB) == 0) return;
  const int error = errno;
  close(m_descriptor);
  if (error == EWOULDBLOCK)
    throw Error(Error::Kind::Environment, "%1: another session is writing this journal", m_path);
  fail(m_path, "the journal cannot be locked", error);
}

Journal::~Journal() { close(m_descriptor); }

std::unique_ptr<Journal> Journal::create(const std::string& path, const std::string& start_file,
                                         const SettleOptions& settle, std::uint64_t state) {
  std::error_code ignored;
  if (fs::exists(path, ignored))
    throw Error(Error::Kind::BadInput,
                "%1: there is a journal already; accepted: a new name, or restore this one", path);
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    throw Error(Error::Kind::Environment, "%1: there is no folder \"%2\" for the journal", path,
                folder.string());
  JournalStart start;
  start.file =
      (fs::path(folder_from(path, folder_of(start_file))) / fs::path(start_file).filename())
          .generic_string();
  start.hash = hash_of_file(start_file, start.bytes);
  start.settle = settle;
  start.state = state;
  keep_start_file(start_file, start_copy_of(path));
  const std::string line = journal_line(start_json(start));
  write_file_atomically(path, line);
  return std::unique_ptr<Journal>(new Journal(path, line.size()));
}

std::unique_ptr<Journal> Journal::reopen(const std::string& path, const JournalContent& content) {
  std::unique_ptr<Journal> journal(new Journal(path, content.whole_bytes));
  struct stat now {};
  if (fstat(journal->m_descriptor, &now) != 0) fail(path, "the journal cannot be read", errno);
  if (static_cast<std::uintmax_t>(now.st_size) != content.all_bytes)
    throw Error(Error::Kind::Environment, "%1: another session has written this journal", path);
  if (content.torn() && ftruncate(journal->m_descriptor, static_cast<off_t>(journal->m_size)) != 0)
    fail(path, "the journal cannot be written", errno);
  return journal;
}

void Journal::append_line(const std::string& line) {
  const auto failed = [&](int error) {
    // Cuts off the written part of the line; if that fails too, nothing more is written, so that it
    // stays a torn last line.
    if (ftruncate(m_descriptor, static_cast<off_t>(m_size)) != 0) m_size = 0;
    fail(m_path, "the journal cannot be written", error);
  };
  if (m_size == 0) fail(m_path, "the journal cannot be written", EIO);
  for (size_t done = 0; done < line.size();) {
    const ssize_t written = ::write(m_descriptor, line.data() + done, line.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) failed(errno);
    done += static_cast<size_t>(written);
  }
  if (fdatasync(m_descriptor) != 0) failed(errno);
  m_size += line.size();
}

void Journal::append_step(const SessionStep& step) {
  JournalJson operations = JournalJson::array();
  for (const Operation& operation : step.operations)
    operations.push_back(operation_json(operation));
  append_line(journal_line({{"do", operations.size() == 1 ? operations[0] : operations},
                            {"settle", settle_json(step.settle)},
                            {"state", hash_text(step.fingerprint)}}));
}

void Journal::append_undo(std::uint64_t state) {
  append_line(journal_line({{"undo", true}, {"state", hash_text(state)}}));
}

void Journal::append_redo(std::uint64_t state) {
  append_line(journal_line({{"redo", true}, {"state", hash_text(state)}}));
}

void Journal::append_saved(const std::string& file) {
  append_line(journal_line(JournalJson{{"saved", file}}));
}

}  // namespace trivet
