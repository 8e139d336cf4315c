// Changes of looks as steps between those of the session: which of the two undo and redo take next.
#pragma once

#include <string>
#include <vector>

#include "apps/edit/document/document_options.h"
#include "apps/edit/document/looks.h"

namespace trivet::edit {

struct LookStep {
  size_t after = 0;  // steps of the session that were done before it
  std::string name;  // "hide"
  Looks before, now;
};

/// A session knows nothing of looks: a change of them cuts off the steps that it could redo, and
/// they stay with it unseen until its next step.
class LookSteps {
 public:
  /// The newest step of all: what was undone is forgotten. It may have been made of looks from
  /// before the last undo or redo: then it keeps what it changes, and begins at the looks of now.
  void add(LookStep step);
  /// The session has a new step.
  void follow_new_step();

  /// The change that is undone (redone) next; null: a step of the session is.
  const LookStep* to_undo(size_t session_done) const;
  const LookStep* to_redo(size_t session_done) const;
  void undo();
  void redo();
  /// @param num_steps  of the session. @return those that are not cut off.
  size_t num_seen(size_t num_steps) const { return num_steps < m_end ? num_steps : m_end; }

  /// Both in order. @param labels  of the session's steps.
  History merged(const std::vector<std::string>& labels, size_t session_done) const;
  size_t num_done() const { return m_num_done; }

 private:
  void learn(const Looks& from, const Looks& to);
  /// The looks of now: as steps have left them, forgotten ones too, else as given.
  Looks now(Looks looks) const;

  std::vector<LookStep> m_steps;  // ordered by `after`; the first m_num_done of them are done
  size_t m_num_done = 0;
  Looks m_now;                    // of what steps have ever changed:
  std::vector<ObjectId> m_known;  // each once
  bool m_knows_collections = false;
  size_t m_end = static_cast<size_t>(-1);  // steps of the session from here on are cut off
};

}  // namespace trivet::edit
