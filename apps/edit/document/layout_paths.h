// Paths in layouts and journals. Private.
#pragma once

#include <string>

#include "ops/files/layout/layout.h"

namespace trivet {
struct JournalContent;
}

namespace trivet::edit {

/// Rebases the layout: relative model paths become relative to `folder`.
Layout moved_layout(Layout layout, const std::string& folder);

/// Scene file to which a journal's session would save; empty: none.
std::string saved_file_of(const std::string& journal, const JournalContent& content);

/// Removes the journal and its companion files.
void remove_recovery_files(const std::string& journal);

}  // namespace trivet::edit
