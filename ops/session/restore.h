// Sessions from files: opened from a layout or a scene, restored from a journal, saved.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/files/layout/run.h"
#include "ops/session/session.h"

namespace trivet {

class OthersScene;

struct OpenedSession {
  Session session;
  std::string start_file;       // layout or scene
  std::string model_folder;     // where relative model paths start: the start file's
  double clearance = 0;         // that a scene file was settled with; 0: the default
  std::vector<Sentence> notes;  // refused operations of a layout, what a scene file lost
  SettleRules rules = {};       // that hold: those asked for, else the file's, else the defaults
  std::shared_ptr<OthersScene> others = {};  // of a scene of another program; see others.h
};

struct NewJournal {
  std::string path;  // of a new file that keeps the steps; empty: none

  /// Keep the models, too, beside it: the session can be restored whatever becomes of their files.
  bool keep_models = false;
};

/// A layout (.json) is run; a scene (.glb) is read, and its contacts are brought up to date.
/// @param options  `settle` and `rules` are for the layout's operations.
/// @throws Error: what reading throws; Journal::create().
OpenedSession open_session(const std::string& file, const RunOptions& options,
                           const ImportLimits& limits, const NewJournal& journal = {});

/// A session of its own on the scene as it is now, without steps; models and shapes are shared.
OpenedSession copy_of(const OpenedSession& opened, const ImportLimits& limits);

struct RestoredSession {
  OpenedSession opened;  // notes: also what was dropped, and what differs
  bool exact = true;     // all steps gave the same bits; otherwise its journal is not kept further
};

/// The session that a journal kept, up to the last committed step, undone steps and all. The start
/// file is found by its content: as JOURNAL.start, else under its own name.
///
/// Where a result differs from what was committed, because a model has changed or by another
/// version of Trivet, the steps from there on have the poses that the journal recorded; a model
/// that cannot be read is a box of its size. Journals of version 1 recorded none: the session ends
/// before the first step that differs.
/// @param go_on  the session keeps the journal from here on.
/// @throws Error (BadInput): read_journal(); the start file is gone or has changed.
RestoredSession restore_session(const std::string& journal, const RunOptions& options,
                                const ImportLimits& limits, bool go_on);

/// Clearance that a file of the scene states; 0: the default.
double settled_clearance(const OpenedSession& opened);

/// The bytes that save_session() writes, of a file in the folder of the start.
std::string scene_bytes(const OpenedSession& opened, const std::string& version);

/// Writes the scene atomically, then notes in the session that it is saved.
/// @throws Error as write_scene_file(); BadInput when `path` is the journal or a model's file.
void save_session(OpenedSession& opened, const std::string& version, const std::string& path);

}  // namespace trivet
