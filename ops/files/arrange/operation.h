// Private. The operation "arrange" of layouts, journals and sessions.
#pragma once

#include <string>
#include <vector>

#include "ops/files/json/text.h"
#include "ops/operations/operations.h"

namespace trivet {

/// Reads strictly what the schema of arrangements says, with "op" beside it; names are left to the
/// scene.
/// @throws Error (BadInput) with the place, the value and what is accepted.
ArrangeOperation read_arrange(const JsonPlace& place);

/// @throws Error (BadInput) for names that are none of these.
void check_names(const JsonPlace& arrange, const std::vector<std::string>& names);

}  // namespace trivet
