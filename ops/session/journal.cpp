#include "ops/session/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/io/atomic_file.h"
#include "core/io/model_bytes.h"
#include "core/io/staged_files.h"
#include "ops/files/json/operations.h"
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
  // A line without its end was being written when the program died.
  size_t begin = 0;
  for (size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(text.substr(begin, end - begin));
  return lines;
}

bool same_bytes(const std::string& a, const std::string& b) {
  std::uintmax_t bytes_a = 0, bytes_b = 0;
  return hash_of_file(a, bytes_a) == hash_of_file(b, bytes_b) && bytes_a == bytes_b;
}

std::string models_of(const std::string& journal) { return journal + ".models"; }

void write_kept_model(const std::string& path, const Model& model) {
  std::error_code ignored;
  // The name is the content's fingerprint: a file that is there is the same.
  if (fs::exists(path, ignored)) return;
  StagedFiles staged;
  staged.add(path, bytes_of_model(model));
  staged.commit();
}

// Models of files.
void add_models(const Scene& scene, const std::vector<ObjectId>& ids,
                std::set<std::shared_ptr<const Model>>& out) {
  for (const ObjectId id : ids)
    if (scene.contains(id) && !scene.at(id).model->path.empty()) out.insert(scene.at(id).model);
}

// @param journal  that keeps the models themselves, too; empty: none.
RecordedModels record(const std::set<std::shared_ptr<const Model>>& models,
                      const std::string& journal) {
  RecordedModels out;
  for (const auto& model : models) {
    out.push_back(recorded_model(*model));
    if (!journal.empty()) write_kept_model(kept_model_of(journal, out.back().fingerprint), *model);
  }
  // The order must not depend on addresses of models.
  std::sort(out.begin(), out.end(),
            [](const RecordedModel& a, const RecordedModel& b) { return a.request < b.request; });
  return out;
}

void check_there_is_room(const std::string& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored))
    throw Error(Error::Kind::BadInput,
                "%1: there is a journal already; accepted: a new name, or restore this one", path);
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    throw Error(Error::Kind::Environment, "%1: there is no folder \"%2\" for the journal", path,
                folder.string());
}

// The file as the journal names it.
std::string named_from(const std::string& journal, const std::string& file) {
  return (fs::path(folder_from(journal, folder_of(file))) / fs::path(file).filename())
      .generic_string();
}

/// Files beside a new journal, which vanish unless it is there, too.
class NewCompanions {
 public:
  explicit NewCompanions(const std::string& journal) {
    std::error_code ignored;
    for (const std::string& path : {start_copy_of(journal), models_of(journal)})
      if (!fs::exists(path, ignored)) m_new.push_back(path);
  }
  ~NewCompanions() {
    std::error_code ignored;
    for (const std::string& path : m_new) fs::remove_all(path, ignored);
  }
  NewCompanions(const NewCompanions&) = delete;
  NewCompanions& operator=(const NewCompanions&) = delete;

  void keep() { m_new.clear(); }

 private:
  std::vector<std::string> m_new;
};

}  // namespace

std::string start_copy_of(const std::string& journal) { return journal + ".start"; }

std::string kept_model_of(const std::string& journal, const std::string& fingerprint) {
  return (fs::path(models_of(journal)) / (fingerprint + ".model")).string();
}

void keep_start_copy(const std::string& journal, const std::string& start_file) {
  const std::string copy = start_copy_of(journal);
  std::error_code ignored;
  // An equal copy of an earlier session serves again.
  if (!fs::exists(copy, ignored)) return copy_file_atomically(start_file, copy);
  // A second name of the start file would change with it.
  if (!fs::equivalent(start_file, copy, ignored) && same_bytes(start_file, copy)) return;
  throw Error(Error::Kind::BadInput,
              "%1: is there already, and would be replaced by the journal's copy of \"%2\"; "
              "accepted: another name of the journal",
              copy, start_file);
}

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
    // A line whose checksum is wrong is allowed at the end alone, as a torn one.
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

Journal::Journal(std::string path, std::uintmax_t size, bool keep_models)
    : m_path(std::move(path)), m_size(size), m_keeps_models(keep_models) {
  m_descriptor = ::open(m_path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  // The lock ends with the process: no journal stays locked by a crash.
  if (m_descriptor < 0) fail(m_path, "the journal cannot be opened", errno);
  if (flock(m_descriptor, LOCK_EX | LOCK_NB) == 0) return;
  const int error = errno;
  close(m_descriptor);
  if (error == EWOULDBLOCK)
    throw Error(Error::Kind::Environment, "%1: another session is writing this journal", m_path);
  fail(m_path, "the journal cannot be locked", error);
}

Journal::~Journal() { close(m_descriptor); }

std::unique_ptr<Journal> Journal::create(const std::string& path, JournalStart start,
                                         const Scene& scene) {
  check_there_is_room(path);
  // Companions are written first and vanish if anything below fails.
  NewCompanions companions(path);
  keep_start_copy(path, start.file);
  std::uintmax_t bytes = 0;
  // The copy is what the session begins from: it must be what was read.
  if (hash_of_file(start_copy_of(path), bytes) != start.hash || bytes != start.bytes)
    throw Error(Error::Kind::Environment, "%1: has changed while it was opened; open it again",
                start.file);
  start.file = named_from(path, start.file);
  Models models;
  add_models(scene, scene.ids(), models);
  start.models = record(models, start.keep_models ? path : "");
  const std::string line = journal_line(start_json(start));
  // The journal's first line makes the session: it is there as a whole or not at all.
  write_file_atomically(path, line);
  companions.keep();
  std::unique_ptr<Journal> journal(new Journal(path, line.size(), start.keep_models));
  journal->m_recorded = std::move(models);
  return journal;
}

std::unique_ptr<Journal> Journal::reopen(const std::string& path, const JournalContent& content) {
  std::unique_ptr<Journal> journal(
      new Journal(path, content.whole_bytes, content.start.keep_models));
  struct stat now {};
  if (fstat(journal->m_descriptor, &now) != 0) fail(path, "the journal cannot be read", errno);
  // The file may have grown since it was read, by a session that held the lock.
  if (static_cast<std::uintmax_t>(now.st_size) != content.all_bytes)
    throw Error(Error::Kind::Environment, "%1: another session has written this journal", path);
  // The torn end is cut off, so that the next line begins on its own.
  if (content.torn() && ftruncate(journal->m_descriptor, static_cast<off_t>(journal->m_size)) != 0)
    fail(path, "the journal cannot be written", errno);
  return journal;
}

// A step written to a file without a name is lost, and one behind another program's bytes cannot be
// read.
void Journal::check_unchanged() const {
  struct stat now {};
  if (fstat(m_descriptor, &now) != 0) fail(m_path, "the journal cannot be read", errno);
  if (now.st_nlink == 0)
    throw Error(Error::Kind::Environment,
                "%1: the journal was deleted, and no further step is done; save the scene", m_path);
  if (static_cast<std::uintmax_t>(now.st_size) != m_size)
    throw Error(Error::Kind::Environment,
                "%1: another program has changed the journal, and no further step is done; save "
                "the scene",
                m_path);
}

void Journal::append_line(const std::string& line) {
  // A line behind a torn one could not be read: nothing more is written.
  if (m_is_broken) fail(m_path, "the journal cannot be written", EIO);
  check_unchanged();
  const auto failed = [&](int error) {
    // Cuts off the written part of the line; if that fails too, nothing more is written, so that it
    // stays a torn last line.
    m_is_broken = ftruncate(m_descriptor, static_cast<off_t>(m_size)) != 0;
    fail(m_path, "the journal cannot be written", error);
  };
  for (size_t done = 0; done < line.size();) {
    const ssize_t written = ::write(m_descriptor, line.data() + done, line.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) failed(errno);
    done += static_cast<size_t>(written);
  }
  // The step counts only when the disk has it.
  if (fdatasync(m_descriptor) != 0) failed(errno);
  m_size += line.size();
}

void Journal::append_step(const SessionStep& step, const Scene& scene,
                          const std::vector<ObjectId>& changed) {
  JournalJson operations = JournalJson::array();
  for (const Operation& operation : step.operations)
    operations.push_back(operation_json(operation));
  Models models;
  add_models(scene, changed, models);
  // Each model is recorded once, by the first step that needs it.
  std::erase_if(models, [&](const auto& model) { return m_recorded.contains(model); });
  JournalJson line = {{"do", operations.size() == 1 ? operations[0] : operations},
                      {"settle", settle_json(step.settle)},
                      {"state", hash_text(step.fingerprint)}};
  if (!models.empty()) line["models"] = models_json(record(models, m_keeps_models ? m_path : ""));
  line["poses"] = poses_json(recorded_poses(scene, changed));
  // The line is written before models count as recorded: a failure leaves both undone.
  append_line(journal_line(line));
  m_recorded.merge(models);  // moves nodes: nothing can fail
}

void Journal::set_recorded(const Scene& scene) { add_models(scene, scene.ids(), m_recorded); }

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
