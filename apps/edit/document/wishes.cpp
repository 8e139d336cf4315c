#include "apps/edit/document/wishes.h"

#include <QtGlobal>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/quoted.h"

namespace trivet::edit {
namespace {

using Json = nlohmann::ordered_json;

bool matches(const std::string& name, const std::string& pattern) {
  const size_t star = pattern.find('*');
  if (star == std::string::npos) return name == pattern;
  const std::string head = pattern.substr(0, star), tail = pattern.substr(star + 1);
  return name.size() >= head.size() + tail.size() && name.starts_with(head) && name.ends_with(tail);
}

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
  if (names.size() > 3) return std::to_string(names.size()) + " objects";
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + quoted(name);
  return out;
}

std::string centimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", 100 * metres);
  return text;
}

std::string label_of(const std::string& is) {
  for (const WishKind& kind : wish_kinds())
    if (is == kind.is) return kind.label;
  return is;
}

std::string numbers_text(const Json& entry) {
  const auto number = [&](const char* key) {
    return entry.contains(key) && entry[key].is_number();
  };
  if (entry.contains("gap") && entry["gap"].is_array() && entry["gap"].size() == 2)
    return ", " + centimetres(entry["gap"][0].get<double>()) + " to " +
           centimetres(entry["gap"][1].get<double>()) + " cm";
  if (number("distance")) return ", " + centimetres(entry["distance"].get<double>()) + " cm";
  if (number("part")) return ", " + centimetres(entry["part"].get<double>()) + " %";
  return "";
}

std::optional<double> weight_of(const Json& entry) {
  if (!entry.contains("weight") || !entry["weight"].is_number()) return std::nullopt;
  return entry["weight"].get<double>();
}

Wish wish_of(const Json& entry) {
  Wish out;
  const std::string is = entry.value("is", "");
  out.a = names_at(entry, entry.contains("of") ? "of" : "a");
  out.b = names_at(entry, entry.contains("on") ? "on" : "b");
  out.text = listed(out.a) + " " + label_of(is);
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
                     [&](const std::string& p) { return matches(name, p); });
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
  const Json document = Json::parse(json, nullptr, false);
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

Wishes::Part Wishes::part(const std::vector<std::string>& things, std::uint64_t seed,
                          const std::map<std::string, std::string>& carried_by) const {
  const auto is_thing = [&](const std::vector<std::string>& names) {
    return std::any_of(things.begin(), things.end(),
                       [&](const std::string& thing) { return any_matches(names, thing); });
  };
  const Json document = document_of(m_json);
  Json out = document, relations = Json::array(), chosen = Json::array();
  Part part;
  std::set<std::string> supported;
  const Json listed = document.value("relations", Json::array());
  for (size_t i = 0; i < m_list.size(); ++i) {
    const std::string is = listed[i].is_object() ? listed[i].value("is", "") : "";
    const bool is_pattern = listed[i].is_object() && listed[i].contains("of");
    const bool supports = is == "on" || is == "in" || is_pattern;
    const Wish& wish = m_list[i];
    // Of a pattern all have to be among the things.
    const bool whole = std::all_of(wish.a.begin(), wish.a.end(),
                                   [&](const std::string& name) { return is_thing({name}); });
    const bool is_of_all = is == "keep" || is == "stands";
    if (supports ? !(is_pattern ? whole : is_thing(wish.a))
                 : !is_of_all && !is_thing(wish.a) && !is_thing(wish.b))
      continue;
    relations.push_back(listed[i]);
    part.entries.push_back(i);
    for (const std::string& thing : things)
      if (supports && any_matches(wish.a, thing)) supported.insert(thing);
  }
  for (const std::string& thing : things) {
    Json entry = {{"object", thing}};
    for (const Json& known : document.value("things", Json::array()))
      if (matches(thing, known.value("object", known.value("objects", "")))) {
        entry = known;
        entry.erase("objects");
        entry["object"] = thing;
      }
    chosen.push_back(std::move(entry));
    const auto below = carried_by.find(thing);
    if (supported.count(thing) || below == carried_by.end()) continue;
    relations.push_back({{"is", "on"}, {"a", thing}, {"b", below->second}});
    part.entries.push_back(m_list.size());
  }
  out["seed"] = seed;
  out["things"] = std::move(chosen);
  out["relations"] = std::move(relations);
  part.json = out.dump();
  return part;
}

}  // namespace trivet::edit
