// Response times of a window with 1,000 objects.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Opens, orbits, drags; prints milliseconds. The document has a saucer at rest.
/// @param folder  contains saucer.glb.
void measure_large_scene(Document& document, MainWindow& window, User& user, const QString& folder);

}  // namespace trivet::edit::test
