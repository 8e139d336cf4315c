// Arranging by relations: "on", "right_of", "facing", "row", ...
#pragma once

#include "trivet/operations.h"

TRIVET_BEGIN

/// Places objects so that all hard relations hold and all is at rest, as one step; or refuses, and
/// the refusal names the smallest set of wishes that cannot be met together, and what is missing.
/// @param problem  the section "arrange" as JSON (docs/reference/arrangements):
///   {"things": [{"object": "plate"}], "relations": [{"is": "on", "a": "*", "b": "table"}]}
/// @throws Error (BadInput) naming the place, the value and what is accepted.
TRIVET_API Result arrange(Scene& scene, const std::string& problem, const Run& run = {});

TRIVET_END
