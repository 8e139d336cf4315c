// Results of an arrangement as JSON and as text.
#include <algorithm>
#include <sstream>

#include "ops/files/arrange/problem.h"
#include "ops/files/report/json_parts.h"

namespace trivet {
namespace {

OrderedJson conflict_json(const Conflict& conflict) {
  OrderedJson out = {{"thing", conflict.thing},
                     {"constraints", in_english(conflict.constraints)},
                     {"as_things_stand", conflict.as_they_stand}};
  out["missing"] = conflict.missing ? OrderedJson(*conflict.missing) : OrderedJson();
  return out;
}

}  // namespace

std::string arrangement_json(const Arrangement& arrangement, const ArrangeResult& result) {
  OrderedJson out = {{"status", to_string(result.status)},
                     {"seed", arrangement.seed},
                     {"attempts", result.num_attempts},
                     {"puts", result.num_puts},
                     {"refused_puts", result.num_refused},
                     {"evictions", result.num_evictions},
                     {"improvements", result.num_improvements},
                     {"milliseconds", result.milliseconds},
                     {"put", {{"milliseconds", result.put_milliseconds}}}};
  if (!result.ok()) out["reason"] = result.reason();
  if (result.conflict) out["conflict"] = conflict_json(*result.conflict);
  out["relations"] = OrderedJson::array();
  for (const ArrangeResult::Holds& r : result.relations)
    out["relations"].push_back({{"relation", r.relation}, {"hard", r.hard}, {"cost", r.cost}});
  return out.dump();
}

std::string arrangement_text(const ArrangeResult& result) {
  std::ostringstream out;
  out << "arrange: " << to_string(result.status) << "; " << result.num_puts << " PUTs, "
      << result.num_refused << " of them not kept, " << result.num_evictions << " evictions, "
      << result.num_attempts << (result.num_attempts == 1 ? " attempt" : " attempts");
  if (result.num_improvements) out << ", " << result.num_improvements << " improvements";
  out << "\n";
  if (!result.ok()) out << "  " << result.reason() << "\n";
  double worst = 0;
  size_t num_soft = 0;
  for (const ArrangeResult::Holds& r : result.relations)
    if (!r.hard) worst = std::max(worst, r.cost), ++num_soft;
  if (!result.relations.empty())
    out << "  " << result.relations.size() - num_soft << " hard relations hold";
  if (num_soft)
    out << "; of " << num_soft << " soft ones the worst is off by " << worst << " tolerances";
  if (!result.relations.empty()) out << "\n";
  return out.str();
}

}  // namespace trivet
