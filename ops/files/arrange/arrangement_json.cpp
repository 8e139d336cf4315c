#include "ops/files/arrange/arrangement_json.h"

#include <algorithm>

#include "core/base/limits.h"
#include "ops/files/arrange/relation_json.h"
#include "ops/files/json/values.h"

namespace trivet {
namespace {

constexpr int kMaxEvictions = 100'000, kMaxAttempts = 1000;
constexpr double kLeastZone = 1e-3;  // metres
constexpr double kLeastYawStep = 1;  // degrees
constexpr size_t kMaxZones = 10'000;

constexpr std::pair<const char*, Vec3 (*)()> kFronts[] = {
    {"x", [] { return Vec3(1, 0, 0); }},
    {"-x", [] { return Vec3(-1, 0, 0); }},
    {"y", [] { return Vec3(0, 1, 0); }},
    {"-y", [] { return Vec3(0, -1, 0); }},
};

class ArrangementReader {
 public:
  explicit ArrangementReader(ProblemNames names) : m_names(std::move(names)) {}

  Arrangement read(const JsonPlace& place, const std::vector<std::string>& otherwise) {
    if (const auto seed = place.find("seed")) {
      if (!seed->value().is_number_unsigned() || seed->value().get<std::uint64_t>() > kMaxSeed)
        seed->refuse("a whole number from 0 to 2^53");
      m_out.seed = seed->value().get<std::uint64_t>();
    }
    read_count(place, "evictions", 0, kMaxEvictions, m_out.max_evictions);
    read_count(place, "attempts", 1, kMaxAttempts, m_out.max_attempts);
    read_count(place, "improvements", 0, kMaxEvictions, m_out.max_improvements);
    read_things(place, otherwise);
    if (const auto fronts = place.find("fronts")) read_fronts(*fronts);
    if (const auto zones = place.find("zones")) read_all_zones(*zones);
    if (const auto surfaces = place.find("surfaces")) read_all_surfaces(*surfaces);
    size_t entry = 0;
    if (const auto relations = place.find("relations"))
      for (const JsonPlace& item : relations->items()) {
        const size_t before = m_out.relations.size();
        read_relation(item, m_names, m_out);
        for (size_t r = before; r < m_out.relations.size(); ++r) m_out.relations[r].entry = entry;
        ++entry;
      }
    return std::move(m_out);
  }

 private:
  void read_things(const JsonPlace& place, const std::vector<std::string>& otherwise) {
    if (const auto things = place.find("things"))
      for (const JsonPlace& item : things->items()) read_thing(item);
    else
      for (const std::string& name : otherwise) m_out.things.push_back({name});
    std::vector<std::string> names;
    names.reserve(m_out.things.size());
    for (const Thing& thing : m_out.things) names.push_back(thing.object);
    m_names.set_things(std::move(names));
  }

  void read_thing(const JsonPlace& place) {
    if (place.find("object"))
      place.expect_object({"object"}, {"pose", "yaw"});
    else
      place.expect_object({"objects"}, {"pose", "yaw"});
    Thing thing;
    if (const auto pose = place.find("pose")) thing.pose = read_pose_choice(*pose);
    if (const auto yaw = place.find("yaw")) read_yaw(*yaw, thing);
    const auto one = place.find("object");
    for (const std::string& each : one ? std::vector<std::string>{m_names.one(*one)}
                                       : m_names.matching(place.at("objects"))) {
      const auto same = [&](const Thing& other) { return other.object == each; };
      if (std::any_of(m_out.things.begin(), m_out.things.end(), same))
        place.fail(say("\"%1\" is named before; accepted: each object once", each));
      thing.object = each;
      m_out.things.push_back(thing);
    }
  }

  // Turns to choose from, a step between them, or any.
  static void read_yaw(const JsonPlace& place, Thing& out) {
    if (place.value() == "any") {
      out.any_yaw = true;
    } else if (place.value().is_object()) {
      place.expect_object({"step"}, {});
      const double step = place.at("step").number(kLeastYawStep, 360);
      for (double yaw = 0; yaw < 360 - 1e-9; yaw += step) out.yaws_deg.push_back(yaw);
    } else {
      for (const JsonPlace& item : place.items())
        out.yaws_deg.push_back(item.number(-kMaxAngleDeg, kMaxAngleDeg));
    }
  }

  static PoseChoice read_pose_choice(const JsonPlace& place) {
    if (place.value() == "upright") return {PoseChoice::Kind::Upright};
    if (place.value() == "as_modelled") return {PoseChoice::Kind::AsModelled};
    if (place.value() == "free") return {PoseChoice::Kind::Free};
    if (place.value() == "stable") return {PoseChoice::Kind::Stable};
    if (place.value() == "side") return {PoseChoice::Kind::Side};
    if (place.value().is_number_unsigned() && place.value() < 1'000'000)
      return {PoseChoice::Kind::Number, place.value().get<int>()};
    place.refuse(
        "\"upright\", \"as_modelled\", \"free\", \"stable\", \"side\" or the number of a stable "
        "pose, as trivet info --poses has them");
  }

  void read_fronts(const JsonPlace& place) {
    if (!place.value().is_object()) place.refuse("an object of names and their fronts");
    for (const auto& [pattern, value] : place.value().items()) {
      const JsonPlace front = place.at(pattern.c_str());
      for (const std::string& name : m_names.matching(pattern, front))
        m_out.fronts[name] = read_front(front);
    }
  }

  void read_all_zones(const JsonPlace& place) {
    if (!place.value().is_object()) place.refuse("an object of names and lists of zones");
    for (const auto& [pattern, value] : place.value().items()) {
      const JsonPlace zones = place.at(pattern.c_str());
      for (const std::string& name : m_names.matching(pattern, zones))
        read_zones(zones, name, m_out.zones);
    }
  }

  void read_all_surfaces(const JsonPlace& place) {
    if (!place.value().is_object()) place.refuse("an object of names and their surfaces");
    std::map<std::string, ProblemNames::Surfaces> out;
    for (const auto& [pattern, value] : place.value().items()) {
      const JsonPlace surfaces = place.at(pattern.c_str());
      for (const std::string& name : m_names.matching(pattern, surfaces))
        out[name] = read_surfaces(surfaces);
    }
    m_names.set_surfaces(std::move(out));
  }

  ProblemNames m_names;
  Arrangement m_out;
};

}  // namespace

Vec3 read_front(const JsonPlace& place) {
  const auto* const known = std::find_if(std::begin(kFronts), std::end(kFronts),
                                         [&](const auto& f) { return place.value() == f.first; });
  if (known == std::end(kFronts)) place.refuse("\"x\", \"-x\", \"y\" or \"-y\"");
  return known->second();
}

std::map<std::string, int> read_surfaces(const JsonPlace& place) {
  if (!place.value().is_object()) place.refuse("an object of names and numbers of surfaces");
  std::map<std::string, int> out;
  for (const auto& [name, value] : place.value().items())
    out[name] = read_level_number(place.at(name.c_str()));
  return out;
}

void read_zones(const JsonPlace& place, const std::string& object, std::vector<Zone>& out) {
  for (const JsonPlace& item : place.items()) {
    item.expect_object({"name", "box"}, {});
    const auto corners = item.at("box").items();
    if (corners.size() != 2) item.at("box").refuse("two corners [x, y, z]");
    Zone zone{object, item.at("name").text(), read_position(corners[0]), read_position(corners[1])};
    if (!((zone.upper - zone.lower).minCoeff() >= kLeastZone))
      item.at("box").refuse("the lower corner first, the upper one 1 mm beyond it or more");
    out.push_back(std::move(zone));
    if (out.size() > kMaxZones) item.fail(say("too many zones; accepted: %1", kMaxZones));
  }
}

Arrangement read_arrangement(const JsonPlace& place, ArrangementPlace kind, ProblemNames names,
                             const std::vector<std::string>& otherwise) {
  if (kind == ArrangementPlace::InOperation)
    place.expect_object({"op"}, {"seed", "things", "relations", "fronts", "zones", "surfaces",
                                 "evictions", "attempts", "improvements"});
  else
    place.expect_object({}, {"seed", "things", "relations", "fronts", "zones", "surfaces",
                             "evictions", "attempts", "improvements"});
  return ArrangementReader(std::move(names)).read(place, otherwise);
}

}  // namespace trivet
