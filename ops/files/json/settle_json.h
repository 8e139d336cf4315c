// Private. Rules of settling as JSON: in layouts and journals.
#pragma once

#include "ops/base/options.h"
#include "ops/files/json/text.h"

namespace trivet {

/// "perfect_friction", "whole_at_rest", "literal_paper_rules", "robust", as far as they are there.
/// @throws Error (BadInput) with the place, the value and what is accepted.
SettleRules read_settle_rules(const JsonPlace& place);

/// Writes the rules that are stated; "robust" where it is true.
nlohmann::ordered_json settle_rules_json(const SettleRules& rules);

}  // namespace trivet
