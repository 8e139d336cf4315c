// Sessions that did not end as they should. Private.
#pragma once

#include "apps/edit/document/document.h"

namespace trivet::edit {

/// Newest first. Those that another editor is writing are left out, and those in which nothing was
/// done since they were saved; the files of the latter are removed.
std::vector<Recoverable> recoverable_sessions(const std::string& folder);
void discard_session(const std::string& journal);

}  // namespace trivet::edit
