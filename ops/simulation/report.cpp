#include <algorithm>
#include <sstream>

#include "core/base/count_of.h"
#include "ops/files/json/text.h"
#include "ops/simulation/simulate.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kTold = 1e-3;  // metres

Json simulated_json(const SimulatedScene& simulated) {
  Json json = {{"simulator", simulated.simulator},
               {"seconds", simulated.seconds},
               {"penetration", simulated.penetration},
               {"warnings", simulated.num_warnings}};
  json["objects"] = Json::array();
  for (const SimulatedObject& o : simulated.objects)
    json["objects"].push_back({{"name", o.name}, {"moved", o.moved}, {"turned_deg", o.turned_deg}});
  return json;
}

}  // namespace

std::string simulation_json(const SimulationExport& done, const SimulationOptions& options,
                            const SimulatedScene* simulated) {
  Json json = {{"trivet", 1},
               {"files", done.files},
               {"density", options.density ? Json(*options.density) : Json("materials")},
               {"friction", options.friction ? Json(*options.friction) : Json("materials")},
               {"collision", to_string(options.collision)},
               {"hull_clearance", options.hull_clearance},
               {"floor_friction", done.scene.floor_friction}};
  json["objects"] = Json::array();
  for (const SimulationBody& body : done.scene.bodies)
    json["objects"].push_back({{"name", body.name},
                               {"file_name", body.file_name},
                               {"fixed", body.fixed},
                               {"mass", body.mass},
                               {"friction", body.friction},
                               {"restitution", body.restitution},
                               {"parts", done.scene.models[body.model].parts.size()}});
  json["overlaps"] = Json::array();
  for (const PartOverlap& o : done.overlaps)
    json["overlaps"].push_back({{"a", o.a},
                                {"b", o.b},
                                {"depth", o.depth},
                                {"allowed", o.allowed},
                                {"part_pairs", o.num_part_pairs}});
  json["notes"] = in_english(done.notes);
  if (simulated) json["simulated"] = simulated_json(*simulated);
  return readable_json(json);
}

std::string simulation_text(const SimulationExport& done) {
  std::ostringstream out;
  size_t num_renamed = 0;
  for (const SimulationBody& body : done.scene.bodies) {
    if (body.name == body.file_name) continue;
    ++num_renamed;
    out << "\"" << body.name << "\" is called " << body.file_name << "\n";
  }
  for (const Sentence& note : done.notes) out << in_english(note) << "\n";
  for (const PartOverlap& o : done.overlaps)
    out << "overlap: \"" << o.a << "\" and \"" << o.b << "\": " << short_number(o.depth)
        << " m deep\n";
  out << count_of(done.scene.bodies.size(), "object") << ", "
      << count_of(done.files.size() - 1, "mesh file") << ", " << num_renamed << " renamed, "
      << count_of(done.overlaps.size(), "pair") << " whose convex parts overlap\n";
  return out.str();
}

bool stays(const SimulatedScene& simulated) {
  const auto is_near = [](const SimulatedObject& o) { return o.moved <= kStays; };
  return simulated.num_warnings == 0 &&
         std::all_of(simulated.objects.begin(), simulated.objects.end(), is_near);
}

std::string simulated_text(const SimulatedScene& simulated) {
  std::vector<SimulatedObject> moved = simulated.objects;
  std::erase_if(moved, [](const SimulatedObject& o) { return o.moved <= kTold; });
  std::stable_sort(
      moved.begin(), moved.end(),
      [](const SimulatedObject& a, const SimulatedObject& b) { return a.moved > b.moved; });
  std::ostringstream out;
  for (const SimulatedObject& o : moved)
    out << "\"" << o.name << "\" moved by " << short_number(o.moved) << " m, turned by "
        << short_number(o.turned_deg) << " degrees\n";
  out << simulated.simulator << ", " << simulated.seconds << " s: " << moved.size() << " of "
      << count_of(simulated.objects.size(), "object") << " moved by more than a millimetre, "
      << count_of(simulated.num_warnings, "warning") << "\n";
  return out.str();
}

}  // namespace trivet
