// The asset browser and collections in the window.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// @param folder  for models and the cache.
void browse_models(Document& document, MainWindow& window, User& user, const QString& folder);
/// Thumbnails are kept, and made again when a file changes. Without a window.
void keep_thumbnails(const QString& folder);
/// A model that could not be read is read again the next time. Without a window.
void forget_errors(const QString& folder);
/// Leaves no unsaved changes.
void collect_objects(Document& document, MainWindow& window, User& user, const QString& folder);
/// Each of several files has a row; what is chosen is remembered for their folder.
void import_files(Document& document, MainWindow& window, User& user, const QString& folder);
/// Closing the import dialog stops what reads a file.
void stop_reading(const QString& folder);
void drop_files(Document& document, MainWindow& window, User& user, const QString& folder);

}  // namespace trivet::edit::test
