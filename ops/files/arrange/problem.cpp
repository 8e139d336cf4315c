#include "ops/files/arrange/problem.h"

#include <set>

#include "ops/files/arrange/arrangement_json.h"
#include "ops/files/json/input_text.h"
#include "ops/files/json/text.h"
#include "ops/files/layout/named_objects.h"

namespace trivet {
namespace {

// Objects that stand nowhere and that no operation names.
std::vector<std::string> left_over(const Layout& layout) {
  std::set<std::string> used;
  for (const Operation& operation : layout.operations) used.insert(object_name(operation));
  std::vector<std::string> out;
  for (const LayoutObject& object : layout.objects)
    if (!object.pose && !used.count(object.name)) out.push_back(object.name);
  return out;
}

}  // namespace

Problem parse_problem(const std::string& text, const std::string& file) {
  const nlohmann::json document = parse_json(text, file);
  const JsonPlace root(document, file);
  root.at("arrange");  // layouts need none, problems do
  if (const auto scene = root.find("scene"))
    scene->fail("scenes of other programs cannot be arranged; accepted: objects with models");
  Problem out{parse_layout(text, file), {}};
  const nlohmann::json whole = {{"arrange", nlohmann::json::parse(out.layout.arrange)}};
  out.arrangement =
      read_arrangement(JsonPlace(whole, file).at("arrange"), ArrangementPlace::InSection,
                       ProblemNames(objects_after(out.layout).names()), left_over(out.layout));
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
