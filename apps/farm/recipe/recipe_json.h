// Parts of recipes as JSON. Private.
#pragma once

#include "apps/farm/recipe/recipe.h"
#include "ops/files/json/text.h"

namespace trivet::farm {

/// A number, or [low, high].
Interval read_interval(const JsonPlace& place, double lower, double upper);
Counts read_counts(const JsonPlace& place, int lower, int upper);
int read_integer(const JsonPlace& place, int lower, int upper);

RecipeGroup read_group(const JsonPlace& place);
RecipeMove read_move(const JsonPlace& place);
Acceptance read_acceptance(const JsonPlace& place);

}  // namespace trivet::farm
