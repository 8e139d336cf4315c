#include "ops/files/arrange/problem.h"

#include <algorithm>
#include <set>

#include "core/base/limits.h"
#include "core/base/nearest_name.h"
#include "ops/arrange/angles.h"
#include "ops/files/json/input_text.h"
#include "ops/files/json/json_text.h"

namespace trivet {
namespace {

constexpr int kMaxEvictions = 100'000, kMaxAttempts = 1000;

constexpr std::pair<const char*, Vec3 (*)()> kFronts[] = {
    {"x", [] { return Vec3(1, 0, 0); }},
    {"-x", [] { return Vec3(-1, 0, 0); }},
    {"y", [] { return Vec3(0, 1, 0); }},
    {"-y", [] { return Vec3(0, -1, 0); }},
};

bool matches(const std::string& name, const std::string& pattern) {
  const size_t star = pattern.find('*');
  if (star == std::string::npos) return name == pattern;
  const std::string head = pattern.substr(0, star), tail = pattern.substr(star + 1);
  return name.size() >= head.size() + tail.size() && name.starts_with(head) && name.ends_with(tail);
}

class ProblemReader {
 public:
  ProblemReader(const JsonPlace& place, const Layout& layout) : m_layout(layout) {
    for (const LayoutObject& object : layout.objects) m_names.push_back(object.name);
    for (const Operation& operation : layout.operations) {
      m_used.insert(object_name(operation));
      if (std::holds_alternative<AppendOperation>(operation))
        m_names.push_back(object_name(operation));
    }
    read(place);
  }
  Arrangement take() { return std::move(m_out); }

 private:
  void read(const JsonPlace& place) {
    place.expect_object({}, {"seed", "things", "relations", "evictions", "attempts"});
    if (const auto seed = place.find("seed")) {
      if (!seed->value().is_number_unsigned() || seed->value().get<std::uint64_t>() > kMaxSeed)
        seed->refuse("a whole number from 0 to 2^53");
      m_out.seed = seed->value().get<std::uint64_t>();
    }
    read_count(place, "evictions", 0, kMaxEvictions, m_out.max_evictions);
    read_count(place, "attempts", 1, kMaxAttempts, m_out.max_attempts);
    if (const auto things = place.find("things"))
      for (const JsonPlace& item : things->items()) read_thing(item);
    else
      take_all_things();
    if (const auto relations = place.find("relations"))
      for (const JsonPlace& item : relations->items()) read_relation(item);
  }

  static void read_count(const JsonPlace& place, const char* key, int lower, int upper, int& out) {
    const auto found = place.find(key);
    if (!found) return;
    const double value = found->number(lower, upper);
    if (value != static_cast<int>(value)) found->refuse("a whole number");
    out = static_cast<int>(value);
  }

  // Those that stand nowhere and that no operation names.
  void take_all_things() {
    for (const LayoutObject& object : m_layout.objects)
      if (!object.pose && !m_used.count(object.name)) m_out.things.push_back({object.name});
  }

  // --- names -------------------------------------------------------------------------------------

  std::vector<std::string> names(const JsonPlace& place) const {
    const std::string pattern = place.text();
    std::vector<std::string> out;
    for (const std::string& name : m_names)
      if (matches(name, pattern)) out.push_back(name);
    if (out.empty())
      place.refuse("the name of one of /objects, or one with * for any letters" +
                   did_you_mean(pattern, m_names));
    return out;
  }

  std::string name(const JsonPlace& place, bool or_floor = false) const {
    std::string out = place.text();
    if (or_floor && out == "floor") return out;
    if (std::find(m_names.begin(), m_names.end(), out) == m_names.end())
      place.refuse(
          (or_floor ? "\"floor\" or the name of one of /objects" : "the name of one of /objects") +
          did_you_mean(out, m_names));
    return out;
  }

  // --- things ------------------------------------------------------------------------------------

  void read_thing(const JsonPlace& place) {
    if (place.find("object"))
      place.expect_object({"object"}, {"pose", "yaw"});
    else
      place.expect_object({"objects"}, {"pose", "yaw"});
    Thing thing;
    if (const auto pose = place.find("pose")) thing.pose = read_pose_choice(*pose);
    if (const auto yaw = place.find("yaw"))
      for (const JsonPlace& item : yaw->items())
        thing.yaws_deg.push_back(item.number(-kMaxAngleDeg, kMaxAngleDeg));
    const auto one = place.find("object");
    for (const std::string& each :
         one ? std::vector<std::string>{name(*one)} : names(place.at("objects"))) {
      const auto same = [&](const Thing& other) { return other.object == each; };
      if (std::any_of(m_out.things.begin(), m_out.things.end(), same))
        place.fail("\"" + each + "\" is named before; accepted: each object once");
      thing.object = each;
      m_out.things.push_back(thing);
    }
  }

  static PoseChoice read_pose_choice(const JsonPlace& place) {
    if (place.value() == "upright") return {PoseChoice::Kind::Upright};
    if (place.value() == "as_modelled") return {PoseChoice::Kind::AsModelled};
    if (place.value() == "free") return {PoseChoice::Kind::Free};
    if (place.value() == "stable") return {PoseChoice::Kind::Stable};
    if (place.value().is_number_unsigned() && place.value() < 1'000'000)
      return {PoseChoice::Kind::Number, place.value().get<int>()};
    place.refuse(
        "\"upright\", \"as_modelled\", \"free\", \"stable\" or the number of a stable pose, as "
        "trivet info "
        "--poses has them");
  }

  // --- relations ---------------------------------------------------------------------------------

  void read_relation(const JsonPlace& place) {
    const std::string is = place.at("is").text();
    if (is == "row" || is == "grid") return read_pattern(place, is == "grid");
    if (is == "keep") return read_keep(place);
    for (int k = 0; k <= static_cast<int>(RelationKind::At); ++k) {
      const auto kind = static_cast<RelationKind>(k);
      if (is == to_string(kind)) return read_relation_of(place, kind);
    }
    if (is == "next_to") return read_relation_of(place, RelationKind::Near, 0.1);
    std::vector<std::string> known{"next_to", "row", "grid", "keep"};
    for (int k = 0; k <= static_cast<int>(RelationKind::At); ++k)
      known.emplace_back(to_string(static_cast<RelationKind>(k)));
    std::string list;
    for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
    place.at("is").refuse("one of " + list + did_you_mean(is, known));
  }

  void read_relation_of(const JsonPlace& place, RelationKind kind, double nearness = 0) {
    Relation r;
    r.kind = kind;
    switch (kind) {
      case RelationKind::On:
        place.expect_object({"is", "a", "b"}, {"level"});
        r.b = name(place.at("b"), true);
        if (const auto level = place.find("level")) r.level = read_level(*level);
        break;
      case RelationKind::In:
        place.expect_object({"is", "a", "b"}, {});
        r.b = name(place.at("b"));
        break;
      case RelationKind::Against:
        place.expect_object({"is", "a", "b"}, {"side", "gap", "overlap", "tolerance", "weight"});
        r.b = name(place.at("b"));
        r.upper = 0.01;
        if (const auto side = place.find("side")) r.side = read_side(*side);
        break;
      case RelationKind::Near:
        place.expect_object({"is", "a", "b"}, {"distance", "tolerance", "weight"});
        r.b = name(place.at("b"));
        r.upper = nearness > 0 ? nearness : place.at("distance").number(0, kMaxLength);
        if (const auto d = place.find("distance")) r.upper = d->number(0, kMaxLength);
        break;
      case RelationKind::LeftOf:
      case RelationKind::RightOf:
      case RelationKind::InFrontOf:
      case RelationKind::Behind:
        place.expect_object({"is", "a", "b"}, {"gap", "overlap", "tolerance", "weight"});
        r.b = name(place.at("b"));
        break;
      case RelationKind::Facing:
      case RelationKind::Away:
        place.expect_object({"is", "a"}, {"b", "point", "tolerance", "weight"});
        read_target(place, r);
        r.tolerance = 5;
        break;
      case RelationKind::Aligned:
      case RelationKind::Parallel:
      case RelationKind::Same:
        place.expect_object({"is", "a", "b"}, {"tolerance", "weight"});
        r.b = name(place.at("b"));
        r.tolerance = 2;
        break;
      case RelationKind::Centred:
        place.expect_object({"is", "a", "b"}, {"along", "offset", "tolerance", "weight"});
        r.b = name(place.at("b"));
        r.tolerance = 0.01;
        read_centred(place, r);
        break;
      case RelationKind::Within:
        place.expect_object({"is", "a", "region"}, {"tolerance", "weight"});
        r.region = read_region(place.at("region"));
        break;
      case RelationKind::At:
        place.expect_object({"is", "a", "point"}, {"tolerance", "weight"});
        r.point = read_point(place.at("point"));
        r.tolerance = 0.01;
        break;
    }
    read_common(place, r);
    for (const std::string& a : names(place.at("a"))) {
      if (a == r.b) place.at("b").refuse("another object than a");
      r.a = a;
      m_out.relations.push_back(r);
    }
  }

  static void read_common(const JsonPlace& place, Relation& r) {
    if (const auto gap = place.find("gap")) {
      const auto both = gap->numbers(2, 0, kMaxLength);
      if (both[0] > both[1]) gap->refuse("[least, most] with the least first");
      r.lower = both[0], r.upper = both[1];
    }
    if (const auto overlap = place.find("overlap")) r.overlap = overlap->number(0, 1);
    if (const auto t = place.find("tolerance")) r.tolerance = t->number(1e-5, kMaxLength);
    if (const auto weight = place.find("weight")) r.weight = weight->number(0, 1e6);
  }

  void read_target(const JsonPlace& place, Relation& r) const {
    const auto b = place.find("b"), point = place.find("point");
    if (b.has_value() == point.has_value()) place.fail("accepted: either \"b\" or \"point\"");
    if (b) r.b = name(*b);
    if (point) r.point = read_point(*point);
  }

  static void read_centred(const JsonPlace& place, Relation& r) {
    if (const auto along = place.find("along")) {
      if (along->value() != "x" && along->value() != "y" && along->value() != "both")
        along->refuse("\"x\", \"y\" or \"both\"");
      r.along_x = along->value() != "y";
      r.along_y = along->value() != "x";
    }
    if (const auto offset = place.find("offset")) r.offset = read_point(*offset);
  }

  static int read_level(const JsonPlace& place) {
    if (place.value() == "top") return -1;
    if (place.value() == "bottom") return 0;
    if (place.value().is_number_integer() && place.number() >= -1000 && place.number() <= 1000)
      return place.value().get<int>();
    place.refuse(
        "\"top\", \"bottom\", or a number as trivet info --surfaces has them, from above if "
        "negative");
  }

  static Side read_side(const JsonPlace& place) {
    for (const Side side : {Side::Front, Side::Back, Side::Left, Side::Right})
      if (place.value() == to_string(side)) return side;
    place.refuse("\"front\", \"back\", \"left\" or \"right\"");
  }

  static Vec2 read_point(const JsonPlace& place) {
    const auto p = place.numbers(2, -kMaxLength, kMaxLength);
    return {p[0], p[1]};
  }

  static std::vector<Vec2> read_region(const JsonPlace& place) {
    std::vector<Vec2> out;
    for (const JsonPlace& corner : place.items()) out.push_back(read_point(corner));
    bool convex = out.size() >= 3;
    for (size_t i = 0; convex && i < out.size(); ++i)
      for (size_t j = 0; j < out.size(); ++j)
        convex = convex &&
                 cross(Vec2(out[(i + 1) % out.size()] - out[i]), Vec2(out[j] - out[i])) >= 0 &&
                 out[(i + 1) % out.size()] != out[i];
    if (!convex) place.refuse("at least 3 corners [x, y] of a convex polygon, counter-clockwise");
    return out;
  }

  // --- patterns and distances --------------------------------------------------------------------

  void read_pattern(const JsonPlace& place, bool grid) {
    place.expect_object({"is", "of", "on"},
                        {"level", "gap", "align", "across", "inset", "order", "columns"});
    Pattern pattern;
    pattern.kind = grid ? Pattern::Kind::Grid : Pattern::Kind::Row;
    pattern.things = read_names(place.at("of"));
    pattern.on = name(place.at("on"));
    if (const auto level = place.find("level")) pattern.level = read_level(*level);
    if (const auto gap = place.find("gap")) pattern.gap = gap->number(0, kMaxLength);
    if (const auto align = place.find("align"))
      pattern.align = read_align(*align, {"left", "centre", "right", "spread"});
    if (const auto across = place.find("across"))
      pattern.across = read_align(*across, {"front", "centre", "back"});
    if (const auto inset = place.find("inset")) pattern.inset = inset->number(0, kMaxLength);
    if (const auto order = place.find("order")) {
      if (order->value() != "listed" && order->value() != "any")
        order->refuse("\"listed\" or \"any\"");
      pattern.shuffled = order->value() == "any";
    }
    if (!grid && place.find("columns")) place.at("columns").fail("a row has none");
    read_count(place, "columns", 1, 1'000'000, pattern.columns);
    m_out.patterns.push_back(std::move(pattern));
  }

  // A pattern, or a list of names and patterns.
  std::vector<std::string> read_names(const JsonPlace& place) const {
    if (!place.value().is_array()) return names(place);
    std::vector<std::string> out;
    for (const JsonPlace& item : place.items())
      for (const std::string& each : names(item)) {
        if (std::find(out.begin(), out.end(), each) != out.end()) item.refuse("each object once");
        out.push_back(each);
      }
    if (out.empty()) place.refuse("at least one object");
    return out;
  }

  static Pattern::Align read_align(const JsonPlace& place,
                                   const std::vector<std::string>& accepted) {
    std::string list;
    for (size_t i = 0; i < accepted.size(); ++i) {
      if (place.value() == accepted[i]) return static_cast<Pattern::Align>(i);
      list += (list.empty() ? "\"" : ", \"") + accepted[i] + "\"";
    }
    place.refuse("one of " + list);
  }

  void read_keep(const JsonPlace& place) {
    place.expect_object({"is", "a", "distance"}, {"except"});
    KeepApart keep;
    keep.things = read_names(place.at("a"));
    keep.distance = place.at("distance").number(0, kMaxLength);
    if (const auto except = place.find("except"))
      for (const JsonPlace& item : except->items()) {
        const auto both = item.items();
        if (both.size() != 2) item.refuse("two names or patterns");
        for (const std::string& a : names(both[0]))
          for (const std::string& b : names(both[1]))
            if (a != b) keep.except.emplace_back(std::min(a, b), std::max(a, b));
      }
    m_out.keeps.push_back(std::move(keep));
  }

  const Layout& m_layout;
  std::vector<std::string> m_names;
  std::set<std::string> m_used;
  Arrangement m_out;
};

// Fronts of objects, which are taken out of the document.
std::map<std::string, Vec3> take_fronts(const JsonPlace& root, nlohmann::json& rest) {
  std::map<std::string, Vec3> out;
  size_t index = 0;
  for (const JsonPlace& object : root.at("objects").items()) {
    if (object.value().is_object())
      if (const auto front = object.find("front")) {
        const auto known = std::find_if(std::begin(kFronts), std::end(kFronts),
                                        [&](const auto& f) { return front->value() == f.first; });
        if (known == std::end(kFronts)) front->refuse("\"x\", \"-x\", \"y\" or \"-y\"");
        out[object.at("name").text()] = known->second();
        rest["objects"][index].erase("front");
      }
    ++index;
  }
  return out;
}

}  // namespace

Problem parse_problem(const std::string& text, const std::string& file) {
  const nlohmann::json document = parse_json(text, file);
  const JsonPlace root(document, file);
  const JsonPlace section = root.at("arrange");
  if (const auto scene = root.find("scene"))
    scene->fail("scenes of other programs cannot be arranged; accepted: objects with models");
  nlohmann::json rest = document;
  rest.erase("arrange");
  const auto fronts = take_fronts(root, rest);
  Problem out;
  out.layout = parse_layout(rest.dump(), file);
  out.arrangement = ProblemReader(section, out.layout).take();
  out.arrangement.fronts = fronts;
  return out;
}

Problem read_problem(const std::string& path, std::uintmax_t max_bytes) {
  return parse_problem(read_input_text(path, max_bytes, TextKind::Json), path);
}

Layout arranged_layout(const Layout& layout, const Scene& scene, const ArrangeResult& result) {
  Layout out = layout;
  for (const ArrangeResult::Placed& placed : result.placed)
    out.operations.push_back(
        StandOperation{{placed.object}, scene.at(*scene.find(placed.object)).pose});
  return out;
}

}  // namespace trivet
