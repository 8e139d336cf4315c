// Values of joints in the language of the windows.
#pragma once

#include <string>

#include "apps/edit/document/snapshot.h"

namespace trivet::edit {

/// "0.125 m" or "30.0°".
std::string joint_value_in_words(double value, bool turns);
/// "\"drawer\": 0.125 m; stopped by \"cup\"", of a link that is dragged.
std::string dragged_joint_in_words(const SceneSnapshot& scene, const Object& link);

}  // namespace trivet::edit
