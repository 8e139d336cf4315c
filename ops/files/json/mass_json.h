// Private. Masses given to objects, and rules for pairs of objects, in JSON.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/files/json/pair_rule.h"
#include "ops/files/json/text.h"

namespace trivet {

/// Kilograms; or {"kilograms", "centre", "inertia"}: metres and kg m^2 in the object's frame, the
/// latter [xx, yy, zz, xy, xz, yz] about the centre; both may be missing.
GivenMass read_mass(const JsonPlace& place);
nlohmann::ordered_json mass_json(const GivenMass& mass);

/// [{"objects": [name, name], "may_pass": bool, "friction": number}]; the last two may be missing.
std::vector<NamedPairRule> read_pair_rules(const JsonPlace& place);
nlohmann::ordered_json pair_rules_json(const std::vector<NamedPairRule>& rules);

/// Gives each object that a rule names a kind of its own, by name: 1, 2, ... in the order of the
/// names. An object that is added later under that name gets its kind from here, too.
std::map<std::string, PairKind> kinds_by_name(const std::vector<NamedPairRule>& rules);
/// Rules of the scene; its objects get their kinds where they are in it.
void set_pair_rules(const std::vector<NamedPairRule>& rules, Scene& scene);

}  // namespace trivet
