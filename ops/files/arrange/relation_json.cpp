#include "ops/files/arrange/relation_json.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/limits.h"
#include "core/base/nearest_name.h"
#include "ops/arrange/angles.h"
#include "ops/files/json/values.h"

namespace trivet {
namespace {

constexpr int kMaxLevel = 1000;
constexpr size_t kMaxRelations = 100'000;  // those of patterns each for itself
constexpr double kMaxWeight = 1e6, kMostFriction = 1e6;

Side read_side(const JsonPlace& place) {
  for (const Side side : {Side::Front, Side::Back, Side::Left, Side::Right})
    if (place.value() == to_string(side)) return side;
  place.refuse("\"front\", \"back\", \"left\" or \"right\"");
}

Vec2 read_axis(const JsonPlace& place) {
  const Vec2 axis = read_point(place);
  const double length = axis.norm();
  if (!(length >= 1e-6)) place.refuse("a direction [x, y] whose length is not zero");
  return axis / length;
}

relations::Axes read_along(const JsonPlace& place) {
  if (place.value() != "x" && place.value() != "y" && place.value() != "both")
    place.refuse("\"x\", \"y\" or \"both\"");
  return {place.value() != "y", place.value() != "x"};
}

void read_both_ends(const JsonPlace& place, relations::Gap& gap) {
  const auto both = place.numbers(2, 0, kMaxLength);
  if (both[0] > both[1]) place.refuse("[least, most] with the least first");
  gap.lower = both[0], gap.upper = both[1];
}

void read_gap(const JsonPlace& place, relations::GapForm form, relations::Gap& gap) {
  using Form = relations::GapForm;
  if (form == Form::Both || (form == Form::Either && place.value().is_array()))
    return read_both_ends(place, gap);
  if (form == Form::Either && !place.value().is_number())
    place.refuse("a number, or [least, most]");
  gap.upper = place.number(0, kMaxLength);
}

/// Reads one field of a kind by the type of its member.
template <class K>
class FieldReader {
 public:
  FieldReader(const relations::Field<K>& field, const JsonPlace& place, const ProblemNames& names,
              const std::string& b, K& out)
      : m_field(field), m_place(place), m_names(names), m_b(b), m_out(out) {}

  void operator()(double K::*member) const {
    m_out.*member = m_place.number(m_field.least, m_field.most);
  }
  void operator()(std::optional<int> K::*member) const {
    m_out.*member = read_level(m_place, m_names, m_b);
  }
  void operator()(std::optional<Side> K::*member) const { m_out.*member = read_side(m_place); }
  void operator()(Vec2 K::*member) const { m_out.*member = read_point(m_place); }
  void operator()(std::optional<Vec2> K::*member) const { m_out.*member = read_point(m_place); }
  void operator()(std::optional<Vec3> K::*member) const { m_out.*member = read_position(m_place); }
  void operator()(std::vector<Vec2> K::*member) const { m_out.*member = read_region(m_place); }
  void operator()(std::string K::*member) const { m_out.*member = m_names.one(m_place); }
  void operator()(relations::Axes K::*member) const { m_out.*member = read_along(m_place); }
  void operator()(const relations::Direction<K>& direction) const {
    m_out.*direction.member = read_axis(m_place);
  }
  void operator()(relations::GapForm form) const {
    if constexpr (std::is_base_of_v<relations::Gap, K>) read_gap(m_place, form, m_out);
  }

 private:
  const relations::Field<K>& m_field;
  const JsonPlace& m_place;
  const ProblemNames& m_names;
  const std::string& m_b;
  K& m_out;
};

/// @param is_alias  the entry has the kind's other name: no field is required.
template <class K>
void expect_keys(const JsonPlace& place, bool is_alias) {
  std::vector<const char*> required{"is", "a"}, optional;
  if (K::kOther == relations::Other::Needed) required.push_back("b");
  if (K::kOther == relations::Other::Optional) optional.push_back("b");
  for (const auto& field : relations::fields_of<K>())
    (field.is_required && !is_alias ? required : optional).push_back(field.key);
  if (!K::kCarries) optional.insert(optional.end(), {"tolerance", "weight"});
  place.expect_object(required, optional);
}

template <class K>
Relation read_values(const JsonPlace& place, const ProblemNames& names) {
  Relation out = usual<K>();
  K& kind = *out.as<K>();
  if (const auto b = place.find("b"))
    out.b = K::kTakesFloor ? names.one_or_floor(*b) : names.one(*b);
  for (const auto& field : relations::fields_of<K>())
    if (const auto value = place.find(field.key))
      std::visit(FieldReader<K>(field, *value, names, out.b, kind), field.member);
  if (const auto t = place.find("tolerance")) out.tolerance = t->number(kMinTolerance, kMaxLength);
  if (const auto weight = place.find("weight")) out.weight = weight->number(0, kMaxWeight);
  const auto is_given = [&](const char* key) { return place.find(key).has_value(); };
  if (const char* const wrong = kind.wrong(out, is_given)) place.fail(wrong);
  return out;
}

template <class K>
void read_kind(const JsonPlace& place, bool is_alias, const ProblemNames& names, Arrangement& out) {
  expect_keys<K>(place, is_alias);
  Relation relation = read_values<K>(place, names);
  for (const std::string& a : names.subjects(place.at("a"), relation.b)) {
    if (a == relation.b) place.at("b").refuse("another object than a");
    relation.a = a;
    out.relations.push_back(relation);
    if (out.relations.size() > kMaxRelations)
      place.fail(say("with this there are more than %1 relations; accepted: fewer", kMaxRelations));
  }
}

struct KindName {
  const char* name;
  bool is_alias;
  void (*read)(const JsonPlace&, bool, const ProblemNames&, Arrangement&);
};

template <size_t... I>
std::vector<KindName> names_of_kinds(std::index_sequence<I...>) {
  std::vector<KindName> out;
  const auto add = [&]<class K>(const K*) {
    out.push_back({K::kName, false, read_kind<K>});
    if (K::kAlias) out.push_back({K::kAlias, true, read_kind<K>});
  };
  (add(static_cast<const std::variant_alternative_t<I, relations::Kind>*>(nullptr)), ...);
  return out;
}

void read_keep(const JsonPlace& place, const ProblemNames& names, Arrangement& out) {
  place.expect_object({"is", "a", "distance"}, {"except"});
  KeepApart keep;
  keep.things = names.listed(place.at("a"));
  keep.distance = place.at("distance").number(0, kMaxLength);
  if (const auto except = place.find("except"))
    for (const JsonPlace& item : except->items()) {
      const auto both = item.items();
      if (both.size() != 2) item.refuse("two names or patterns");
      for (const std::string& a : names.matching(both[0]))
        for (const std::string& b : names.matching(both[1]))
          if (a != b) keep.except.emplace_back(std::min(a, b), std::max(a, b));
    }
  out.keeps.push_back(std::move(keep));
}

void read_stands(const JsonPlace& place, const ProblemNames& names, Arrangement& out) {
  place.expect_object({"is", "a"}, {"margin", "friction"});
  Steadiness wanted;
  wanted.things = names.listed(place.at("a"));
  if (const auto margin = place.find("margin")) wanted.margin = margin->number(0, kMaxLength);
  if (const auto friction = place.find("friction"))
    wanted.friction = friction->number(0, kMostFriction);
  if (!place.find("margin") && !place.find("friction"))
    place.fail("accepted: with \"margin\", \"friction\" or both");
  out.steadiness.push_back(std::move(wanted));
}

}  // namespace

Vec2 read_point(const JsonPlace& place) {
  const auto p = place.numbers(2, -kMaxLength, kMaxLength);
  return {p[0], p[1]};
}

int read_level(const JsonPlace& place, const ProblemNames& names, const std::string& support) {
  const ProblemNames::Surfaces& surfaces = names.surfaces(support);
  if (place.value().is_string())
    if (const auto known = surfaces.find(place.text()); known != surfaces.end())
      return known->second;
  if (surfaces.empty() || !place.value().is_string()) return read_level_number(place);
  if (place.value() == "top" || place.value() == "bottom") return read_level_number(place);
  std::string list;
  for (const auto& [name, level] : surfaces) list += "\"" + name + "\", ";
  place.refuse(say("%1\"top\", \"bottom\", or a number as trivet info --surfaces has them", list));
}

int read_level_number(const JsonPlace& place) {
  if (place.value() == "top") return -1;
  if (place.value() == "bottom") return 0;
  if (place.value().is_number_integer() && std::abs(place.number()) <= kMaxLevel)
    return place.value().get<int>();
  place.refuse(
      "\"top\", \"bottom\", or a number as trivet info --surfaces has them, from above if "
      "negative");
}

void read_relation(const JsonPlace& place, const ProblemNames& names, Arrangement& out) {
  const std::string is = place.at("is").text();
  if (read_pattern(place, is, names, out)) return;
  if (is == "keep") return read_keep(place, names, out);
  if (is == "stands") return read_stands(place, names, out);
  static const std::vector<KindName> kinds =
      names_of_kinds(std::make_index_sequence<std::variant_size_v<relations::Kind>>());
  std::vector<std::string> known{"row",   "grid",  "circle", "facings",
                                 "along", "stack", "keep",   "stands"};
  for (const KindName& kind : kinds) {
    if (is == kind.name) return kind.read(place, kind.is_alias, names, out);
    known.insert(kind.is_alias ? known.begin() : known.end(), kind.name);
  }
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  place.at("is").refuse(say("one of %1%2", list, did_you_mean(is, known)));
}

void read_count(const JsonPlace& place, const char* key, int lower, int upper, int& out) {
  const auto found = place.find(key);
  if (!found) return;
  const double value = found->number(lower, upper);
  if (value != static_cast<int>(value)) found->refuse("a whole number");
  out = static_cast<int>(value);
}

}  // namespace trivet
