// Scenes that sessions start with, from a layout or a scene file.
#pragma once

#include <string>

#include "ops/files/layout/run.h"
#include "ops/session/recorded.h"
#include "ops/session/restore.h"

namespace trivet {

/// @param content  the file to read; `file` says what it is and where its models are.
/// @param models  of the layout and of the session, as models_in_folder().
/// @throws Error: what reading throws.
OpenedSession open_start(const std::string& content, const std::string& file,
                         const ModelSource& models, const RunOptions& options,
                         const ImportLimits& limits);

/// A layout whose outcome is known: its objects get these poses, and nothing is computed.
OpenedSession open_recorded_layout(const std::string& content, const std::string& file,
                                   const ModelSource& models, const RecordedPoses& poses,
                                   const RunOptions& options, const ImportLimits& limits);

bool is_layout(const std::string& file);

}  // namespace trivet
