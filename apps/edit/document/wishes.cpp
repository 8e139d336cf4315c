#include "apps/edit/document/wishes.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "core/base/error.h"
#include "core/base/quoted.h"
#include "core/io/json.h"
#include "ops/files/arrange/section.h"

namespace trivet::edit {
namespace {

using Json = nlohmann::ordered_json;

// Names at a key: one, or a list.
std::vector<std::string> names_at(const Json& entry, const char* key) {
  std::vector<std::string> out;
  const auto found = entry.find(key);
  if (found == entry.end()) return out;
  if (found->is_string()) out.push_back(found->get<std::string>());
  if (!found->is_array()) return out;
  for (const Json& item : *found)
    if (item.is_string())
      out.push_back(item.get<std::string>());
    else if (item.is_object())
      for (const std::string& name : names_at(item, "things")) out.push_back(name);
  return out;
}

std::string listed(const std::vector<std::string>& names) {
  const int count = static_cast<int>(names.size());
  if (count > 3)
    return QCoreApplication::translate("wishes", "%n objects", nullptr, count).toStdString();
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + quoted(name);
  return out;
}

// Centimetres of metres, percents of shares.
QString hundredths(const Json& number) {
  return QLocale().toString(100 * number.get<double>(), 'g', 4);
}

std::string label_of(const std::string& is) {
  for (const WishKind& kind : wish_kinds())
    if (is == kind.is) return QCoreApplication::translate("wishes", kind.label).toStdString();
  return is;
}

std::string numbers_text(const Json& entry) {
  const auto number = [&](const char* key) {
    return entry.contains(key) && entry[key].is_number();
  };
  QString out;
  if (entry.contains("gap") && entry["gap"].is_array() && entry["gap"].size() == 2)
    out = QCoreApplication::translate("wishes", ", %1 to %2 cm")
              .arg(hundredths(entry["gap"][0]), hundredths(entry["gap"][1]));
  else if (number("distance"))
    out = QString(", %1 cm").arg(hundredths(entry["distance"]));
  else if (number("part"))
    out = QString(", %1 %").arg(hundredths(entry["part"]));
  return out.toStdString();
}

std::optional<double> weight_of(const Json& entry) {
  if (!entry.contains("weight") || !entry["weight"].is_number()) return std::nullopt;
  return entry["weight"].get<double>();
}

bool may_be_soft(const Wish& wish) {
  const bool is_hard =
      wish.is == "on" || wish.is == "in" || wish.is == "keep" || wish.is == "stands";
  return !is_hard && !wish.is_pattern;
}

Wish wish_of(const Json& entry) {
  Wish out;
  out.is = entry.value("is", "");
  out.is_pattern = entry.contains("of");
  out.may_be_soft = may_be_soft(out);
  out.a = names_at(entry, entry.contains("of") ? "of" : "a");
  out.b = names_at(entry, entry.contains("on") ? "on" : "b");
  out.text = listed(out.a) + " " + label_of(out.is);
  if (!out.b.empty()) out.text += " " + listed(out.b);
  out.text += numbers_text(entry);
  out.weight = weight_of(entry);
  return out;
}

Json document_of(const std::string& json) {
  return json.empty() ? Json{{"relations", Json::array()}} : Json::parse(json);
}

bool any_matches(const std::vector<std::string>& patterns, const std::string& name) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& p) { return matches_name(name, p); });
}

bool is_support(const Wish& wish) { return wish.is == "on" || wish.is == "in" || wish.is_pattern; }

bool names_a_thing(const std::vector<std::string>& patterns, const Wishes::Scope& scope) {
  return std::any_of(scope.things.begin(), scope.things.end(),
                     [&](const std::string& thing) { return any_matches(patterns, thing); });
}

// True if all objects of this pattern are there, and things.
bool names_things_alone(const std::string& pattern, const Wishes::Scope& scope) {
  bool any = false;
  for (const std::string& name : scope.names) {
    if (!matches_name(name, pattern)) continue;
    if (!scope.things.count(name)) return false;
    any = true;
  }
  return any;
}

bool concerns(const Wish& wish, const Wishes::Scope& scope) {
  if (wish.is == "keep" || wish.is == "stands") return true;
  if (wish.is_pattern)
    return std::all_of(wish.a.begin(), wish.a.end(), [&](const std::string& pattern) {
      return names_things_alone(pattern, scope);
    });
  return names_a_thing(wish.a, scope) || (!is_support(wish) && names_a_thing(wish.b, scope));
}

// As "things" has it, else by its name alone.
Json thing_entry(const Json& known, const std::string& thing) {
  Json out = {{"object", thing}};
  for (const Json& entry : known)
    if (matches_name(thing, entry.value("object", entry.value("objects", "")))) {
      out = entry;
      out.erase("objects");
      out["object"] = thing;
    }
  return out;
}

// Keys of a problem at which there are names, or objects by their names.
constexpr std::string_view kNameKeys[] = {"a",      "b",      "on",     "of",     "about",
                                          "except", "things", "object", "objects"};
constexpr std::string_view kKeyedByNames[] = {"fronts", "zones", "surfaces"};

bool is_in(std::span<const std::string_view> keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

Json keyed_anew(const Json& by_name, const std::map<std::string, std::string>& names) {
  Json out = Json::object();
  for (const auto& [key, value] : by_name.items()) {
    const auto found = names.find(key);
    out[found == names.end() ? key : found->second] = value;
  }
  return out;
}

void rename_in(Json& value, bool is_name, const std::map<std::string, std::string>& names) {
  if (value.is_string() && is_name) {
    if (const auto found = names.find(value.get<std::string>()); found != names.end())
      value = found->second;
  } else if (value.is_array()) {
    for (Json& item : value) rename_in(item, is_name, names);
  } else if (value.is_object()) {
    for (const auto& item : value.items())
      if (is_in(kKeyedByNames, item.key()) && item.value().is_object())
        item.value() = keyed_anew(item.value(), names);
      else
        rename_in(item.value(), is_in(kNameKeys, item.key()), names);
  }
}

}  // namespace

const std::vector<WishKind>& wish_kinds() {
  using N = WishNumbers;
  static const std::vector<WishKind> kinds = {
      {"on", QT_TRANSLATE_NOOP("wishes", "on"), N::None, false},
      {"in", QT_TRANSLATE_NOOP("wishes", "in"), N::None, false},
      {"right_of", QT_TRANSLATE_NOOP("wishes", "right of"), N::Gap},
      {"left_of", QT_TRANSLATE_NOOP("wishes", "left of"), N::Gap},
      {"in_front_of", QT_TRANSLATE_NOOP("wishes", "in front of"), N::Gap},
      {"behind", QT_TRANSLATE_NOOP("wishes", "behind"), N::Gap},
      {"against", QT_TRANSLATE_NOOP("wishes", "with its back against"), N::Gap},
      {"at_edge", QT_TRANSLATE_NOOP("wishes", "at the edge of"), N::Gap},
      {"near", QT_TRANSLATE_NOOP("wishes", "near"), N::Distance},
      {"facing", QT_TRANSLATE_NOOP("wishes", "facing")},
      {"away", QT_TRANSLATE_NOOP("wishes", "facing away from")},
      {"same", QT_TRANSLATE_NOOP("wishes", "turned as")},
      {"parallel", QT_TRANSLATE_NOOP("wishes", "parallel to")},
      {"perpendicular", QT_TRANSLATE_NOOP("wishes", "perpendicular to")},
      {"aligned", QT_TRANSLATE_NOOP("wishes", "aligned with")},
      {"centred", QT_TRANSLATE_NOOP("wishes", "centred on")},
      {"under", QT_TRANSLATE_NOOP("wishes", "under"), N::Part},
      {"view", QT_TRANSLATE_NOOP("wishes", "in view of"), N::Part},
      {"reach", QT_TRANSLATE_NOOP("wishes", "in reach of"), N::Distance},
  };
  return kinds;
}

Wishes::Wishes(const std::string& json) {
  if (json.empty()) return;
  const Json document = json_if_valid<Json>(json).value_or(Json());
  const bool is_list =
      document.is_object() && (!document.contains("relations") || document["relations"].is_array());
  if (!is_list)
    throw Error(Error::Kind::BadInput,
                "wishes: accepted: a section \"arrange\", as trivet schema arrange has it");
  m_json = json;
  if (!document.contains("relations")) return;
  m_list.reserve(document["relations"].size());
  for (const Json& entry : document["relations"])
    m_list.push_back(entry.is_object() ? wish_of(entry) : Wish());
}

std::uint64_t Wishes::seed() const {
  const Json document = document_of(m_json);
  return document.contains("seed") && document["seed"].is_number_unsigned()
             ? document["seed"].get<std::uint64_t>()
             : 1;
}

Wishes Wishes::with(const NewWish& wish) const {
  const WishKind& kind = wish_kinds().at(wish.kind);
  Json entry = {{"is", kind.is}, {"a", wish.a}, {"b", wish.b}};
  if (kind.numbers == WishNumbers::Gap) entry["gap"] = {wish.lower, wish.upper};
  if (kind.numbers == WishNumbers::Distance) entry["distance"] = wish.upper;
  if (kind.numbers == WishNumbers::Part) entry["part"] = wish.part;
  if (wish.weight && kind.may_be_soft) entry["weight"] = *wish.weight;
  Json document = document_of(m_json);
  document["relations"].push_back(std::move(entry));
  return Wishes(document.dump());
}

Wishes Wishes::without(const std::set<size_t>& entries) const {
  Json document = document_of(m_json), kept = Json::array();
  for (size_t i = 0; i < m_list.size(); ++i)
    if (!entries.count(i)) kept.push_back(document["relations"][i]);
  document["relations"] = std::move(kept);
  return Wishes(document.dump());
}

Wishes Wishes::weighted(size_t entry, std::optional<double> weight) const {
  Json document = document_of(m_json);
  if (weight)
    document["relations"].at(entry)["weight"] = *weight;
  else
    document["relations"].at(entry).erase("weight");
  return Wishes(document.dump());
}

bool Wishes::is_about(size_t entry, const std::string& object) const {
  return any_matches(m_list[entry].a, object) || any_matches(m_list[entry].b, object);
}

Wishes Wishes::renamed(const std::map<std::string, std::string>& names) const {
  if (m_json.empty()) return *this;
  Json document = document_of(m_json);
  rename_in(document, false, names);
  return Wishes(document.dump());
}

Wishes::Part Wishes::part(const Scope& scope, std::uint64_t seed) const {
  Json out = document_of(m_json);
  const Json all = out.value("relations", Json::array()),
             known = out.value("things", Json::array());
  Json things = Json::array(), relations = Json::array();
  Part part;
  std::vector<const Wish*> supports;
  for (size_t i = 0; i < m_list.size(); ++i) {
    if (!concerns(m_list[i], scope)) continue;
    relations.push_back(all[i]);
    part.entries.push_back(i);
    if (is_support(m_list[i])) supports.push_back(&m_list[i]);
  }
  for (const std::string& thing : scope.things) {
    things.push_back(thing_entry(known, thing));
    const auto below = scope.carried_by.find(thing);
    const bool is_supported = std::any_of(supports.begin(), supports.end(), [&](const Wish* wish) {
      return any_matches(wish->a, thing);
    });
    if (is_supported || below == scope.carried_by.end()) continue;
    relations.push_back({{"is", "on"}, {"a", thing}, {"b", below->second}});
    part.entries.push_back(m_list.size());
  }
  out["seed"] = seed;
  out["things"] = std::move(things);
  out["relations"] = std::move(relations);
  part.json = out.dump();
  return part;
}

}  // namespace trivet::edit
