// An hour of an artist's work by mouse and keyboard: from a folder of models to a picture.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Writes the models of the hour: "library" in millimetres (a shelf, a book), "kitchen" in metres
/// (a tray, and those of BREAKFAST).
void write_hour_models(const QString& folder);

/// A screenshot of each step, figures of effort on standard output. Begins with the start page;
/// leaves no unsaved changes. @param folder  of the models, and for what is written.
void work_an_hour(Document& document, MainWindow& window, User& user, const QString& folder);

/// Texts of visible buttons, labels and tabs that are wider than their room.
QStringList cut_off_texts(QWidget& window);

}  // namespace trivet::edit::test
