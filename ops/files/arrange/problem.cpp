#include "ops/files/arrange/problem.h"

#include <set>

#include "ops/files/arrange/arrangement_json.h"
#include "ops/files/json/input_text.h"
#include "ops/files/json/json_text.h"

namespace trivet {
namespace {

ProblemNames names_of(const Layout& layout) {
  std::vector<std::string> out;
  out.reserve(layout.objects.size());
  for (const LayoutObject& object : layout.objects) out.push_back(object.name);
  for (const Operation& operation : layout.operations)
    if (std::holds_alternative<AppendOperation>(operation)) out.push_back(object_name(operation));
  return ProblemNames(std::move(out));
}

// Those that stand nowhere and that no operation names.
std::vector<std::string> left_over(const Layout& layout) {
  std::set<std::string> used;
  for (const Operation& operation : layout.operations) used.insert(object_name(operation));
  std::vector<std::string> out;
  for (const LayoutObject& object : layout.objects)
    if (!object.pose && !used.count(object.name)) out.push_back(object.name);
  return out;
}

// Fronts and zones of objects, which are taken out of the document.
Arrangement take_marks(const JsonPlace& root, nlohmann::json& rest) {
  Arrangement out;
  size_t index = 0;
  for (const JsonPlace& object : root.at("objects").items()) {
    if (const auto front = object.find("front"))
      out.fronts[object.at("name").text()] = read_front(*front);
    if (const auto zones = object.find("zones"))
      read_zones(*zones, object.at("name").text(), out.zones);
    for (const char* const key : {"front", "zones"})
      if (object.find(key)) rest["objects"][index].erase(key);
    ++index;
  }
  return out;
}

// The section with what is beside the objects.
nlohmann::json with_marks(const JsonPlace& root, nlohmann::json section) {
  for (const JsonPlace& object : root.at("objects").items())
    for (const auto& [key, in_section] :
         {std::pair("front", "fronts"), std::pair("zones", "zones")})
      if (const auto mark = object.find(key))
        section[in_section][object.at("name").text()] = mark->value();
  return section;
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
  Arrangement marks = take_marks(root, rest);
  Problem out;
  out.layout = parse_layout(rest.dump(), file);
  out.arrangement = read_arrangement(section, ArrangementPlace::InSection, names_of(out.layout),
                                     left_over(out.layout));
  out.layout.arrange = with_marks(root, section.value()).dump();
  out.arrangement.fronts.merge(marks.fronts);
  out.arrangement.zones.insert(out.arrangement.zones.end(), marks.zones.begin(), marks.zones.end());
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
