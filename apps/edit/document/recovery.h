// Sessions that ended abnormally. Private.
#pragma once

#include "apps/edit/document/document.h"

namespace trivet::edit {

/// Newest first. Skips journals being written by another editor, and sessions without steps since
/// the last save; removes the files of the latter.
std::vector<Recoverable> recoverable_sessions(const std::string& folder);
void discard_session(const std::string& journal);

}  // namespace trivet::edit
