// The journal of a session: a file that grows by one line of JSON per step, each on disk before the
// step counts. From it a session that crashed is restored to its last committed operation.
//
//   {"trivet_journal": 2, "start": {"file", "bytes", "hash"}, "settle", "state", "models", "poses",
//    "keep_models", "sum"}
//   {"do": {operation as in a layout}, "settle": {rules, and what is not default}, "state": hash,
//    "models", "poses", "sum"} (or "do": [operations of one step]; none: mended, poses tell all)
//   {"undo": true, "state", "sum"}, {"redo": true, "state", "sum"}, {"saved": file, "sum"}
//
// "state" is of the objects that the line changed (of the whole scene in the first line), "sum" of
// the text before it. The last line may be torn, by a crash in the middle of it: it was never
// committed, and is dropped.
//
// "poses": {name: [x, y, z, w, x, y, z] or null} of the objects that the line changed (in the first
// line: of all, when the start is a layout), and "models": [{"model", "up", "fingerprint", "box"}]
// that came with it: they bring a step back whose model has changed. JOURNAL.start is a copy of the
// start file, which others may write at any time; JOURNAL.models holds the models, if asked for.
// Version 1 has no "models", "poses" and "keep_models".
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ops/base/options.h"
#include "ops/operations/operations.h"
#include "ops/session/recorded.h"

namespace trivet {

struct SessionStep;

/// Start of the session.
struct JournalStart {
  std::string file;  // layout or scene; relative to the journal's folder
  std::uintmax_t bytes = 0;
  std::string hash;      // of the file's bytes
  SettleOptions settle;  // with which a layout was run
  std::uint64_t state = 0;
  RecordedModels models = {};
  std::optional<RecordedPoses> poses = {};  // of a layout; of a scene file: none are needed
  bool keep_models = false;
  bool of_earlier_version = false;  // whose states are not those of this one
};

struct JournalRecord {
  enum class Kind { Step, Undo, Redo, Saved };
  Kind kind;
  std::vector<Operation> operations;        // of Step
  SettleOptions settle;                     // of Step
  std::uint64_t state = 0;                  // not of Saved
  std::string file;                         // of Saved
  RecordedModels models = {};               // that came with a Step
  std::optional<RecordedPoses> poses = {};  // after a Step; nullopt: version 1
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
  /// A new journal, and JOURNAL.start.
  /// @param start  its hash is that of the bytes that were opened; its file as the program sees it.
  /// @param scene  that the start gave.
  /// @throws Error: BadInput when there is a journal already, or another file has the name of its
  ///   copy; Environment when it cannot be made, or the start file has changed since.
  static std::unique_ptr<Journal> create(const std::string& path, JournalStart start,
                                         const Scene& scene);
  /// Goes on where `content` ends; a torn line is cut off.
  /// @throws Error (Environment): it cannot be written, or another session has it.
  static std::unique_ptr<Journal> reopen(const std::string& path, const JournalContent& content);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// On disk when they return. @throws Error (Environment): it cannot be written, was deleted, or
  ///   another program changed it; the journal is then as it was.
  /// @param changed  by the step, in the scene that it left.
  void append_step(const SessionStep& step, const Scene& scene,
                   const std::vector<ObjectId>& changed);
  void append_undo(std::uint64_t state);
  void append_redo(std::uint64_t state);
  void append_saved(const std::string& file);

  /// The models of these objects are in the journal.
  void set_recorded(const Scene& scene);

  const std::string& path() const { return m_path; }

 private:
  using Models = std::set<std::shared_ptr<const Model>>;

  Journal(std::string path, std::uintmax_t size, bool keep_models);
  void check_unchanged() const;
  void append_line(const std::string& line);

  std::string m_path;
  int m_descriptor = -1;
  std::uintmax_t m_size = 0;
  bool m_keeps_models = false;
  bool m_is_broken = false;  // it ends in a torn line that could not be cut off
  Models m_recorded;
};

/// The copy of the start file.
std::string start_copy_of(const std::string& journal);
/// Makes it if it is missing. @throws Error (BadInput): another file has its name.
void keep_start_copy(const std::string& journal, const std::string& start_file);
/// Where the journal keeps models with this fingerprint; by bytes_of_model() (core/io).
std::string kept_model_of(const std::string& journal, const std::string& fingerprint);
/// Hash of a file's bytes.
std::string hash_of_file(const std::string& path, std::uintmax_t& bytes);

}  // namespace trivet
