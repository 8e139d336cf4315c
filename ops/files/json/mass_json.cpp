#include "ops/files/json/mass_json.h"

#include "core/base/limits.h"
#include "core/scene/transaction.h"
#include "ops/files/json/values.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

Mat3 read_inertia(const JsonPlace& place) {
  const std::vector<double> m = place.numbers(6, -kMaxMass, kMaxMass);
  Mat3 out;
  out << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
  return out;
}

NamedPairRule read_pair_rule(const JsonPlace& place) {
  place.expect_object({"objects"}, {"may_pass", "friction"});
  const std::vector<JsonPlace> names = place.at("objects").items();
  if (names.size() != 2) place.at("objects").refuse("two names, of which one may be \"floor\"");
  NamedPairRule out{names[0].text(), names[1].text(), {}};
  if (out.a == out.b) names[1].refuse("the name of another object");
  if (const auto may = place.find("may_pass")) out.rule.may_pass = may->boolean();
  if (const auto mu = place.find("friction"))
    out.rule.friction = mu->number(kMinFriction, kMaxFriction);
  return out;
}

}  // namespace

GivenMass read_mass(const JsonPlace& place) {
  GivenMass mass;
  if (!place.value().is_object()) {
    mass.kilograms = place.number(kMinMass, kMaxMass);
    return mass;
  }
  place.expect_object({"kilograms"}, {"centre", "inertia"});
  mass.kilograms = place.at("kilograms").number(kMinMass, kMaxMass);
  if (const auto centre = place.find("centre")) mass.centre = read_position(*centre);
  if (const auto inertia = place.find("inertia")) mass.inertia = read_inertia(*inertia);
  if (const auto why = refuse_mass(mass)) place.fail(*why);
  return mass;
}

Json mass_json(const GivenMass& mass) {
  if (!mass.centre && !mass.inertia) return mass.kilograms;
  Json json = {{"kilograms", mass.kilograms}};
  if (mass.centre) json["centre"] = {mass.centre->x(), mass.centre->y(), mass.centre->z()};
  if (mass.inertia) {
    const Mat3& m = *mass.inertia;
    json["inertia"] = {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
  }
  return json;
}

std::vector<NamedPairRule> read_pair_rules(const JsonPlace& place) {
  std::vector<NamedPairRule> out;
  for (const JsonPlace& item : place.items()) out.push_back(read_pair_rule(item));
  return out;
}

Json pair_rules_json(const std::vector<NamedPairRule>& rules) {
  Json json = Json::array();
  for (const NamedPairRule& r : rules) {
    json.push_back({{"objects", {r.a, r.b}}});
    if (r.rule.may_pass) json.back()["may_pass"] = true;
    if (r.rule.friction) json.back()["friction"] = *r.rule.friction;
  }
  return json;
}

std::map<std::string, PairKind> kinds_by_name(const std::vector<NamedPairRule>& rules) {
  std::map<std::string, PairKind> kinds;
  for (const NamedPairRule& r : rules) kinds[r.a] = kinds[r.b] = 0;
  PairKind next = 1;
  for (auto& [name, kind] : kinds) kind = next++;
  return kinds;
}

void set_pair_rules(const std::vector<NamedPairRule>& rules, Scene& scene) {
  if (rules.empty()) return;
  const std::map<std::string, PairKind> kinds = kinds_by_name(rules);
  auto out = std::make_shared<PairRules>();
  for (const NamedPairRule& r : rules) out->set(kinds.at(r.a), kinds.at(r.b), r.rule);
  for (const auto& [name, kind] : kinds)
    if (const auto id = scene.find(name))
      edit_object(scene, *id, [k = kind](Object& o) { o.pair_kind = k; });
  if (const auto floor = kinds.find("floor"); floor != kinds.end())
    scene.floor_kind = floor->second;
  scene.pair_rules = std::move(out);
}

}  // namespace trivet
