// The journal of a session: a file that grows by one line of JSON per step, each on disk before the
// step counts. From it a session that crashed is restored to its last committed operation.
//
//   {"trivet_journal": 1, "start": {"file", "bytes", "hash"}, "settle", "state", "sum"}
//   {"do": {operation as in a layout}, "settle": {rules, and what is not default}, "state": hash,
//   "sum"} (or "do": [operations of one step])
//   {"undo": true, "state", "sum"}, {"redo": true, "state", "sum"}, {"saved": file, "sum"}
//
// "state" is of the objects that the line changed (of the whole scene in the first line), "sum" of
// the text before it. The last line may be torn, by a crash in the middle of it: it was never
// committed, and is dropped. JOURNAL.start is a second name for the start file (or a copy of it),
// because saving replaces the first.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ops/base/options.h"
#include "ops/operations/operations.h"

namespace trivet {

struct SessionStep;

/// Start of the session.
struct JournalStart {
  std::string file;  // layout or scene; relative to the journal's folder
  std::uintmax_t bytes = 0;
  std::string hash;      // of the file's bytes
  SettleOptions settle;  // with which a layout was run
  std::uint64_t state = 0;
};

struct JournalRecord {
  enum class Kind { Step, Undo, Redo, Saved };
  Kind kind;
  std::vector<Operation> operations;  // of Step
  SettleOptions settle;               // of Step
  std::uint64_t state = 0;            // not of Saved
  std::string file;                   // of Saved
};

struct JournalContent {
  JournalStart start;
  std::vector<JournalRecord> records;
  std::uintmax_t whole_bytes = 0;  // of the lines that are whole
  std::uintmax_t all_bytes = 0;    // of the file
  bool torn() const { return all_bytes != whole_bytes; }
};

/// @throws Error (BadInput): no journal, of another version, or damaged before its last line.
JournalContent read_journal(const std::string& path);

class Journal {
 public:
  /// A new journal, and JOURNAL.start. @param start_file  as the program sees it.
  /// @throws Error: BadInput when there is a journal already; Environment when it cannot be made.
  static std::unique_ptr<Journal> create(const std::string& path, const std::string& start_file,
                                         const SettleOptions& settle, std::uint64_t state);
  /// Goes on where `content` ends; a torn line is cut off.
  /// @throws Error (Environment): it cannot be written, or another session has it.
  static std::unique_ptr<Journal> reopen(const std::string& path, const JournalContent& content);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// On disk when they return. @throws Error (Environment); the journal is then as it was.
  void append_step(const SessionStep& step);
  void append_undo(std::uint64_t state);
  void append_redo(std::uint64_t state);
  void append_saved(const std::string& file);

  const std::string& path() const { return m_path; }

 private:
  Journal(std::string path, std::uintmax_t size);
  void append_line(const std::string& line);

  std::string m_path;
  int m_descriptor = -1;
  std::uintmax_t m_size = 0;
};

/// The second name of the start file.
std::string start_copy_of(const std::string& journal);
/// Of a file's bytes.
std::string hash_of_file(const std::string& path, std::uintmax_t& bytes);

}  // namespace trivet
