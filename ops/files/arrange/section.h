// The section "arrange" of a layout, for a scene that is there already.
#pragma once

#include <string>

#include "core/scene/scene.h"
#include "ops/arrange/arrangement.h"
#include "ops/operations/operations.h"

namespace trivet {

/// Names mean what the scene has; without "things", all that is out of it and not fixed.
/// @param json  text of the section. Relation::entry is its place in "relations".
/// @throws Error (BadInput) with the place, the value and what is accepted.
Arrangement parse_arrange_section(const std::string& json, const Scene& scene);

/// True if the pattern is this name, or has one * that stands for any letters of it.
bool matches_name(const std::string& name, const std::string& pattern);

/// The operation that solves it; its names mean what the scene has then.
/// @throws Error (BadInput) as far as no scene is needed.
ArrangeOperation arrange_operation(const std::string& json);

}  // namespace trivet
