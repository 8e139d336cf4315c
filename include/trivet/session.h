// Sessions with a journal: a step counts only when it is on disk.
#pragma once

#include "trivet/scene.h"

TRIVET_BEGIN

/// Opens a scene or a layout, and keeps every step in a new file.
/// @throws Error: BadInput as open_scene(); Environment when the journal cannot be written.
[[nodiscard]] TRIVET_API Scene open_session(const std::string& path, const std::string& journal);

struct Restored {
  Scene scene;
  bool exact = true;               // all steps gave the same bits
  std::vector<std::string> notes;  // what was dropped or has changed
};
/// The session that a journal kept, up to its last committed step.
/// @throws Error (BadInput) when the journal or its start cannot be read.
[[nodiscard]] TRIVET_API Restored restore_session(const std::string& journal);

TRIVET_END
