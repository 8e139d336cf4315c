#include "ops/files/arrange/relation_json.h"

#include <algorithm>
#include <initializer_list>

#include "core/base/limits.h"
#include "core/base/nearest_name.h"
#include "ops/arrange/angles.h"
#include "ops/files/json/values.h"

namespace trivet {
namespace {

constexpr int kMaxLevel = 1000;
constexpr size_t kMaxRelations = 100'000;  // those of patterns each for itself
constexpr double kMaxWeight = 1e6, kMostFriction = 1e6;
constexpr double kNextTo = 0.1, kAgainst = 0.01, kArm = 0.7;  // metres

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

void read_along(const JsonPlace& place, Relation& r) {
  if (place.value() != "x" && place.value() != "y" && place.value() != "both")
    place.refuse("\"x\", \"y\" or \"both\"");
  r.along_x = place.value() != "y";
  r.along_y = place.value() != "x";
}

struct KindKeys {
  RelationKind kind;
  std::initializer_list<const char*> required, optional;
};

const KindKeys kKeys[] = {
    {RelationKind::On, {"is", "a", "b"}, {"level"}},
    {RelationKind::In, {"is", "a", "b"}, {}},
    {RelationKind::Against, {"is", "a", "b"}, {"side", "gap", "overlap", "tolerance", "weight"}},
    {RelationKind::Near, {"is", "a", "b", "distance"}, {"tolerance", "weight"}},
    {RelationKind::LeftOf, {"is", "a", "b"}, {"gap", "overlap", "tolerance", "weight"}},
    {RelationKind::RightOf, {"is", "a", "b"}, {"gap", "overlap", "tolerance", "weight"}},
    {RelationKind::InFrontOf, {"is", "a", "b"}, {"gap", "overlap", "tolerance", "weight"}},
    {RelationKind::Behind, {"is", "a", "b"}, {"gap", "overlap", "tolerance", "weight"}},
    {RelationKind::Facing, {"is", "a"}, {"b", "point", "tolerance", "weight"}},
    {RelationKind::Away, {"is", "a"}, {"b", "point", "tolerance", "weight"}},
    {RelationKind::Aligned, {"is", "a", "b"}, {"tolerance", "weight"}},
    {RelationKind::Parallel, {"is", "a", "b"}, {"tolerance", "weight"}},
    {RelationKind::Perpendicular, {"is", "a", "b"}, {"tolerance", "weight"}},
    {RelationKind::Same, {"is", "a", "b"}, {"tolerance", "weight"}},
    {RelationKind::Centred, {"is", "a", "b"}, {"along", "offset", "tolerance", "weight"}},
    {RelationKind::Within, {"is", "a", "region"}, {"tolerance", "weight"}},
    {RelationKind::At, {"is", "a", "point"}, {"tolerance", "weight"}},
    {RelationKind::Symmetric, {"is", "a", "b"}, {"about", "point", "axis", "tolerance", "weight"}},
    {RelationKind::AtEdge, {"is", "a", "b"}, {"side", "gap", "tolerance", "weight"}},
    {RelationKind::Under, {"is", "a", "b"}, {"part", "tolerance", "weight"}},
    {RelationKind::View, {"is", "a"}, {"b", "height", "point", "part", "tolerance", "weight"}},
    {RelationKind::Reach, {"is", "a"}, {"b", "height", "point", "distance", "tolerance", "weight"}},
};

void expect_keys(const JsonPlace& place, RelationKind kind, bool next_to) {
  if (next_to) return place.expect_object({"is", "a", "b"}, {"distance", "tolerance", "weight"});
  for (const KindKeys& keys : kKeys)
    if (keys.kind == kind) return place.expect_object(keys.required, keys.optional);
}

void read_gap(const JsonPlace& place, Relation& r) {
  const auto both = place.numbers(2, 0, kMaxLength);
  if (both[0] > both[1]) place.refuse("[least, most] with the least first");
  r.lower = both[0], r.upper = both[1];
}

void read_values(const JsonPlace& place, const ProblemNames& names, Relation& r) {
  if (const auto b = place.find("b"))
    r.b = r.kind == RelationKind::On ? names.one_or_floor(*b) : names.one(*b);
  if (const auto level = place.find("level")) r.level = read_level(*level, names, r.b);
  if (const auto side = place.find("side")) r.side = read_side(*side);
  if (const auto gap = place.find("gap")) read_gap(*gap, r);
  if (const auto d = place.find("distance")) {
    if (d->value().is_array() && r.kind == RelationKind::Near)
      read_gap(*d, r);
    else if (!d->value().is_number() && r.kind == RelationKind::Near)
      d->refuse("a number, or [least, most]");
    else
      r.upper = d->number(0, kMaxLength);
  }
  for (const char* const key : {"overlap", "part"})
    if (const auto overlap = place.find(key)) r.overlap = overlap->number(0, 1);
  if (const auto height = place.find("height"))
    r.eye_height = height->number(-kMaxLength, kMaxLength);
  if (const auto along = place.find("along")) read_along(*along, r);
  if (const auto offset = place.find("offset")) r.offset = read_point(*offset);
  if (const auto point = place.find("point")) {
    if (r.is_of_sight()) {
      r.eye = read_position(*point);
    } else {
      r.point = read_point(*point);
    }
  }
  if (const auto about = place.find("about")) r.about = names.one(*about);
  if (const auto axis = place.find("axis")) r.axis = read_axis(*axis);
  if (const auto region = place.find("region")) r.region = read_region(*region);
  if (const auto t = place.find("tolerance")) r.tolerance = t->number(kMinTolerance, kMaxLength);
  if (const auto weight = place.find("weight")) r.weight = weight->number(0, kMaxWeight);
}

void read_kind(const JsonPlace& place, RelationKind kind, bool next_to, const ProblemNames& names,
               Arrangement& out) {
  expect_keys(place, kind, next_to);
  Relation relation = with_defaults(kind);
  read_values(place, names, relation);
  const bool turns = kind == RelationKind::Facing || kind == RelationKind::Away;
  if (turns && relation.b.empty() != relation.point.has_value())
    place.fail("accepted: either \"b\" or \"point\"");
  const bool has_eye = kind == RelationKind::View || kind == RelationKind::Reach;
  if (has_eye && relation.b.empty() != relation.eye.has_value())
    place.fail("accepted: either \"b\" or \"point\"");
  if (has_eye && relation.eye && place.find("height"))
    place.fail("accepted: \"height\" with \"b\", a \"point\" has its own");
  const bool has_point = relation.point.has_value(), has_axis = place.find("axis").has_value();
  const bool has_plane = has_point && has_axis, has_part = has_point || has_axis;
  if (kind == RelationKind::Symmetric && (relation.about.empty() ? !has_plane : has_part))
    place.fail("accepted: either \"about\" an object, or \"point\" and \"axis\"");
  for (const std::string& a : names.subjects(place.at("a"), relation.b)) {
    if (a == relation.b) place.at("b").refuse("another object than a");
    relation.a = a;
    out.relations.push_back(relation);
    if (out.relations.size() > kMaxRelations)
      place.fail(say("with this there are more than %1 relations; accepted: fewer", kMaxRelations));
  }
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

Relation with_defaults(RelationKind kind) {
  Relation out;
  out.kind = kind;
  switch (kind) {
    case RelationKind::Against:
      out.upper = kAgainst;
      break;
    case RelationKind::Near:
      out.upper = kNextTo;
      break;
    case RelationKind::Facing:
    case RelationKind::Away:
      out.tolerance = 5;
      break;
    case RelationKind::Aligned:
    case RelationKind::Parallel:
    case RelationKind::Perpendicular:
    case RelationKind::Same:
      out.tolerance = 2;
      break;
    case RelationKind::AtEdge:
      out.upper = kAgainst;
      break;
    case RelationKind::Reach:
      out.upper = kArm;
      out.tolerance = 0.01;
      break;
    case RelationKind::View:
    case RelationKind::Under:
    case RelationKind::Centred:
    case RelationKind::At:
    case RelationKind::Symmetric:
      out.tolerance = 0.01;
      break;
    default:
      break;
  }
  return out;
}

void read_relation(const JsonPlace& place, const ProblemNames& names, Arrangement& out) {
  const std::string is = place.at("is").text();
  if (read_pattern(place, is, names, out)) return;
  if (is == "keep") return read_keep(place, names, out);
  if (is == "stands") return read_stands(place, names, out);
  if (is == "next_to") return read_kind(place, RelationKind::Near, true, names, out);
  std::vector<std::string> known{"next_to", "row",   "grid", "circle", "facings",
                                 "along",   "stack", "keep", "stands"};
  for (const KindKeys& keys : kKeys) {
    if (is == to_string(keys.kind)) return read_kind(place, keys.kind, false, names, out);
    known.emplace_back(to_string(keys.kind));
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
