// Response times of a window with 1,000 objects.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Opens, orbits, drags; prints milliseconds. The document has a saucer at rest.
/// @param folder  contains saucer.glb. @param textured  with an image on each object.
void measure_large_scene(Document& document, MainWindow& window, User& user, const QString& folder,
                         bool textured);

}  // namespace trivet::edit::test
