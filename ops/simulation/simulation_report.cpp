#include <cstdio>
#include <sstream>

#include "ops/files/json/json_text.h"
#include "ops/simulation/simulation.h"

namespace trivet {

std::string simulation_json(const SimulationExport& done, const SimulationOptions& options) {
  using Json = nlohmann::ordered_json;
  Json json = {{"trivet", 1},
               {"files", done.files},
               {"density", options.density},
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
                               {"parts", done.scene.models[body.model].parts.size()}});
  json["overlaps"] = Json::array();
  for (const PartOverlap& o : done.overlaps)
    json["overlaps"].push_back(
        {{"a", o.a}, {"b", o.b}, {"depth", o.depth}, {"part_pairs", o.num_part_pairs}});
  json["notes"] = done.notes;
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
  for (const std::string& note : done.notes) out << note << "\n";
  for (const PartOverlap& o : done.overlaps)
    out << "overlap: \"" << o.a << "\" and \"" << o.b << "\": " << short_number(o.depth)
        << " m deep\n";
  out << done.scene.bodies.size() << " objects, " << done.files.size() - 1 << " mesh files, "
      << num_renamed << " renamed, " << done.overlaps.size()
      << " pairs whose convex parts overlap\n";
  return out.str();
}

}  // namespace trivet
