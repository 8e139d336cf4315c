#include "ops/files/json/settle_json.h"

namespace trivet {
namespace {

constexpr std::pair<const char*, std::optional<bool> SettleRules::*> kRules[] = {
    {"perfect_friction", &SettleRules::perfect_friction},
    {"whole_at_rest", &SettleRules::whole_at_rest},
    {"literal_paper_rules", &SettleRules::literal_paper_rules},
    {"robust", &SettleRules::robust}};

}  // namespace

SettleRules read_settle_rules(const JsonPlace& place) {
  SettleRules rules;
  for (const auto& [key, rule] : kRules)
    if (const auto value = place.find(key)) rules.*rule = value->boolean();
  return rules;
}

nlohmann::ordered_json settle_rules_json(const SettleRules& rules) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [key, rule] : kRules)
    // Older versions read what is not robust: they do not know the rule.
    if (rules.*rule && (*(rules.*rule) || rule != &SettleRules::robust)) json[key] = *(rules.*rule);
  return json;
}

}  // namespace trivet
