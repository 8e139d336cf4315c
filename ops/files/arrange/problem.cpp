#include "ops/files/arrange/problem.h"

#include <algorithm>
#include <set>

#include "core/base/limits.h"
#include "ops/files/arrange/relation_json.h"
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

ProblemNames names_of(const Layout& layout) {
  std::vector<std::string> out;
  out.reserve(layout.objects.size());
  for (const LayoutObject& object : layout.objects) out.push_back(object.name);
  for (const Operation& operation : layout.operations)
    if (std::holds_alternative<AppendOperation>(operation)) out.push_back(object_name(operation));
  return ProblemNames(std::move(out));
}

class ProblemReader {
 public:
  ProblemReader(const JsonPlace& place, const Layout& layout)
      : m_layout(layout), m_names(names_of(layout)) {
    for (const Operation& operation : layout.operations) m_used.insert(object_name(operation));
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
      for (const JsonPlace& item : relations->items()) read_relation(item, m_names, m_out);
  }

  // Those that stand nowhere and that no operation names.
  void take_all_things() {
    for (const LayoutObject& object : m_layout.objects)
      if (!object.pose && !m_used.count(object.name)) m_out.things.push_back({object.name});
  }

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
    for (const std::string& each : one ? std::vector<std::string>{m_names.one(*one)}
                                       : m_names.matching(place.at("objects"))) {
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

  const Layout& m_layout;
  ProblemNames m_names;
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
