// Objects made anew in another scale or with another axis up, as one step of existing operations.
#pragma once

#include "apps/edit/document/many.h"

namespace trivet::edit {

/// Ways to have the object in another scale or with another axis up, the better ones first: it is
/// deleted, and its model appended so; if it was placed, it is put in its place, from just above
/// or, where that is not free, from above all; then what it carried is put on it again. None: there
/// is no such object.
/// @param scale  metres per unit of the model. @param up  its axis.
std::vector<OperationGroup> rescaling(const SceneSnapshot& scene, const std::string& name,
                                      double scale, UpAxis up, double drop_height);

/// Start of a PUT in the place of `old`: its rotation, the centre of mass at the same place seen
/// from above, the underside by `drop_height` above its own.
Pose start_in_place_of(const Object& old, Object there, double drop_height);

}  // namespace trivet::edit
