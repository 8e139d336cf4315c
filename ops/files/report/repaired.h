// Reports of mending and settling, as JSON and in words.
#pragma once

#include <string>

#include "core/io/json.h"
#include "ops/base/repaired.h"

namespace trivet {

/// A point, metres, as files have it. @param lift  as below.
nlohmann::ordered_json point_in_file(double lift, Vec3 point);

/// {"moved": [{"object", "from", "to", "metres", "degrees"}], "unable": [{"object", "why"}]}; from
/// and to are positions. @param lift  metres to take off heights, as JudgedScene has it.
nlohmann::ordered_json settled_json(const SettledScene& settled, double lift = 0);
/// The same with "tolerance", "supports_meant", "supports_kept", "relations".
nlohmann::ordered_json mended_json(const MendedScene& mended, double lift = 0);
/// The second if something was meant, else the first.
nlohmann::ordered_json repaired_json(const MendedScene& repaired);

/// Lines: how many objects moved, and each with its way; those that stay, and why.
std::string settled_text(const SettledScene& settled);
/// The same, and the supports that were kept, lost and gained.
std::string mended_text(const MendedScene& mended);

}  // namespace trivet
