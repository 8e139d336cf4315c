// The layout that a file of a session's scene keeps.
#pragma once

#include "ops/session/session.h"

namespace trivet {

/// The layout that made the scene, with the rules of `settle`. A scene with objects of no file has
/// no layout that could make it again: then it is empty but for the floor, and the scene file has
/// all there is.
Layout kept_layout(const Session& session, const SettleOptions& settle);

}  // namespace trivet
