// Objects made anew in another scale or with another axis up, as one step of existing operations.
#pragma once

#include "apps/edit/document/many.h"

namespace trivet::edit {

/// The object deleted, and its model appended in another scale or with another axis up; if it was
/// placed, put in its place from just above. What it carried settles. No operations: there is no
/// such object.
/// @param scale  metres per unit of the model. @param up  its axis.
OperationGroup rescaling(const SceneSnapshot& scene, const std::string& name, double scale,
                         UpAxis up, double drop_height);

/// Start of a PUT in the place of `old`: its rotation, the centre of mass at the same place seen
/// from above, the underside by `drop_height` above its own.
Pose start_in_place_of(const Object& old, Object there, double drop_height);

}  // namespace trivet::edit
