// Leaning: an object tilted against another one.
#pragma once

#include <optional>

#include "apps/edit/document/snapshot.h"
#include "ops/operations/turn.h"

namespace trivet::edit {

/// A TURN about the edge of its support that is nearest to the wall, towards the wall until it
/// touches it, and let go there: it leans by friction, or slides down. In a shelf it goes to the
/// nearest side. Nullopt: the object rests on no edge, or there is no wall beside it.
std::optional<TurnOperation> lean_against(const ObjectSnapshot& object, const ObjectSnapshot& wall,
                                          const SceneSnapshot& scene);

}  // namespace trivet::edit
