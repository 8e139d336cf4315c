// Options of a document, and the plain data that it shows of itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/edit/document/thread_detector.h"
#include "core/io/read_model.h"
#include "core/model/model.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

struct DocumentOptions {
  /// Folder of data that must survive a crash: journals, demos, locks. Empty: no recovery.
  std::string recovery_folder;
  std::string version;   // of the program; written to saved files
  SettleOptions settle;  // of all operations, as far as the file states no rules
  SettleRules rules;     // before those of the file
  RunContext context;
  BackendOptions detection;  // `note` is not used: see detection_noted()
  int num_threads = 0;       // of loading; 0: all cores
  ImportLimits limits;
};

/// Detectors that answer the queries of moves and of previews, for display.
struct Detection {
  Answering moves, previews;
};

/// All steps of the session; redoable ones last.
struct History {
  std::vector<std::string> steps;  // "put \"cup\""
  size_t num_done = 0;
};

/// A session that ended abnormally.
struct Recoverable {
  std::string journal;
  std::string file;  // open file; empty: a scene that was never saved
  std::string when;  // of the last step, local time, "2026-11-21 17:54"
  size_t num_steps = 0;
};

/// Options for importing a model.
struct ImportModel {
  std::string file;
  std::string name;             // empty: of the file; made unique
  std::optional<double> scale;  // metres per unit of the file; nullopt: as it states, else 1
  std::optional<UpAxis> up;     // nullopt: as the format states
  bool fixed = false;
  std::optional<Pose> put;  // nullopt: not placed until it is put
};

}  // namespace trivet::edit
