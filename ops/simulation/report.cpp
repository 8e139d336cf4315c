#include <algorithm>
#include <sstream>

#include "core/base/count_of.h"
#include "ops/files/json/text.h"
#include "ops/files/report/json_parts.h"
#include "ops/simulation/simulate.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

Json simulated_json(const SimulatedScene& simulated) {
  Json json = {{"simulator", simulated.simulator},
               {"seconds", simulated.seconds},
               {"penetration", simulated.penetration},
               {"warnings", simulated.num_warnings}};
  const StayedWithin stayed = stayed_within(simulated);
  json["within_1mm"] = stayed.millimetre;
  json["within_2mm_2deg"] = stayed.two_millimetres_and_degrees;
  json["within_1cm"] = stayed.centimetre;
  json["objects"] = Json::array();
  for (const SimulatedObject& o : simulated.objects) {
    Json& object = json["objects"].emplace_back(
        Json{{"name", o.name}, {"moved", o.moved}, {"turned_deg", o.turned_deg}});
    if (o.moved > kTold) object["why"] = in_english(o.why);
  }
  return json;
}

Json body_json(const SimulationExport& done, const SimulationBody& body) {
  Json json = {{"name", body.name},
               {"file_name", body.file_name},
               {"fixed", body.fixed},
               {"mass", body.mass},
               {"friction", body.friction},
               {"restitution", body.restitution},
               {"parts", done.scene.models[body.model].parts.size()}};
  if (!body.own_file.empty()) json["own_file"] = body.own_file;
  if (!body.fixed) {  // of its free joint in MuJoCo, which has its name
    const Vec3& p = body.world_from_link.translation;
    const Rotation& q = body.world_from_link.rotation;
    json["qpos"] = {p.x(), p.y(), p.z(), q.w, q.x, q.y, q.z};
  }
  if (done.stands_out.empty()) return json;
  const StandsOut& farthest = done.stands_out[body.model];
  json["stands_out"] = {
      {"distance", farthest.distance},
      {"at", to_json(world_from_object(body.world_from_link, UpAxis::Z, 1).apply(farthest.at))}};
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
               {"max_error", options.max_error},
               {"hull_clearance", options.hull_clearance},
               {"floor_friction", done.scene.floor_friction}};
  json["objects"] = Json::array();
  for (const SimulationBody& body : done.scene.bodies)
    json["objects"].push_back(body_json(done, body));
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
  for (const SimulatedObject& o : moved) {
    out << "\"" << o.name << "\" moved by " << short_number(o.moved) << " m, turned by "
        << short_number(o.turned_deg)
        << " degrees: " << (o.why.empty() ? "it is not known why" : in_english(listed(o.why)))
        << "\n";
  }
  const StayedWithin stayed = stayed_within(simulated);
  out << simulated.simulator << ", " << simulated.seconds << " s: of "
      << count_of(simulated.objects.size(), "object") << " " << stayed.millimetre
      << " stayed within 1 mm, " << stayed.two_millimetres_and_degrees
      << " within 2 mm and 2 degrees, " << stayed.centimetre << " within 1 cm; "
      << count_of(simulated.num_warnings, "warning") << "\n";
  return out.str();
}

}  // namespace trivet
