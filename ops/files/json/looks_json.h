// Looks of objects and collections as JSON, as the schema of layouts has them.
#pragma once

#include "ops/files/json/text.h"
#include "ops/files/layout/scene_looks.h"

namespace trivet {

/// @throws Error (BadInput): unknown keys, colours out of range, a collection's name or an object
///   in collections that comes twice.
SceneLooks read_looks(const JsonPlace& place);
nlohmann::ordered_json looks_json(const SceneLooks& looks);

}  // namespace trivet
