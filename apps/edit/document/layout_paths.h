// Paths in layouts and journals. Private.
#pragma once

#include <string>

#include "ops/layout/layout.h"

namespace trivet {
struct JournalContent;
}

namespace trivet::edit {

/// The layout as another file: relative model paths start in `folder` from now on.
Layout moved_layout(Layout layout, const std::string& folder);

/// The scene file that the session of a journal would save to; empty: it had none.
std::string saved_file_of(const std::string& journal, const JournalContent& content);

/// The journal and what lies beside it for its sake.
void remove_recovery_files(const std::string& journal);

}  // namespace trivet::edit
