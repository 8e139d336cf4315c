#include "ops/files/foreign/repair_json.h"

#include <cmath>

#include "ops/files/report/repaired.h"
#include "ops/mend/neighbours.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

Json limit_json(double limit) { return std::isfinite(limit) ? Json(limit) : Json(); }

const char* end_text(JointMove::End end) {
  switch (end) {
    case JointMove::End::Reached:
      return "reached";
    case JointMove::End::Limit:
      return "limit";
    case JointMove::End::Blocked:
      break;
  }
  return "blocked";
}

Json support_json(const Scene& scene, const IntendedSupport& support) {
  Json json = {{"object", named(scene, support.on).name}, {"share", support.share}};
  if (support.either_way) json["either_way"] = true;
  return json;
}

Json names_json(const Scene& scene, const std::vector<ObjectId>& ids) {
  Json json = Json::array();
  for (const ObjectId id : ids) json.push_back(scene.at(id).name);
  return json;
}

}  // namespace

Json intent_json(const Scene& scene, const Intent& intent) {
  Json json = {{"tolerance", intent.tolerance}, {"objects", Json::array()}};
  for (const ObjectIntent& o : intent.objects) {
    Json object = {{"object", scene.at(o.id).name}, {"on", Json::array()}};
    for (const IntendedSupport& s : o.on) object["on"].push_back(support_json(scene, s));
    if (o.inside) object["in"] = scene.at(*o.inside).name;
    const IntendedNeighbours around = intended_neighbours(scene, intent, o);
    if (!around.leans_on.empty()) object["leans_on"] = names_json(scene, around.leans_on);
    if (!around.beside.empty()) object["beside"] = names_json(scene, around.beside);
    object["gap"] = o.gap;
    object["level"] = o.is_level;
    object["tilt_deg"] = o.tilt_deg;
    json["objects"].push_back(std::move(object));
  }
  return json;
}

Json joint_json(const Scene& scene, const SceneJoint& joint) {
  Json links = Json::array();
  for (const ObjectId id : joint.links) links.push_back(scene.at(id).name);
  Json json = {{"joint", joint.name},
               {"kind", joint.turns ? "hinge" : "slide"},
               {"value", joint.value},
               {"lower", limit_json(joint.lower)},
               {"upper", limit_json(joint.upper)},
               {"links", links}};
  if (!joint.held.empty()) json["held"] = in_english(joint.held);
  return json;
}

Json joint_move_json(const Scene& scene, double lift, const SceneJoint& joint,
                     const JointMove& move) {
  Json json = joint_json(scene, joint);
  json["end"] = end_text(move.end);
  if (move.end == JointMove::End::Blocked) {
    json["blocked_by"] = named(scene, move.blocker).name;
    json["blocked_at"] = point_in_file(lift, move.point);
  }
  json["carried"] = Json::array();
  for (const ObjectId id : move.carried) json["carried"].push_back(scene.at(id).name);
  return json;
}

}  // namespace trivet
