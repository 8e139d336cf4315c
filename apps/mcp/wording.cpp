#include "apps/mcp/wording.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/count_of.h"
#include "core/base/quoted.h"
#include "ops/base/refusal.h"

namespace trivet::mcp {
namespace {

constexpr size_t kMostNames = 12;
constexpr double kNothing = 1e-9;  // metres and degrees

std::string short_text(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", std::abs(value) < kNothing ? 0.0 : value);
  return text;
}

std::string listed_names(const std::vector<std::string>& names) {
  std::string out;
  for (size_t i = 0; i < names.size() && i < kMostNames; ++i)
    out += (i ? ", " : "") + quoted(names[i]);
  if (names.size() > kMostNames)
    out += " and " + std::to_string(names.size() - kMostNames) + " more";
  return out;
}

std::vector<std::string> names_in(const Json& answer, const char* key) {
  std::vector<std::string> out;
  for (const Json& one : answer.value(key, Json::array()))
    out.push_back(one.is_string() ? one.get<std::string>() : one.value("name", ""));
  return out;
}

// The object's box as it stands, or unturned where it is not in the scene.
Aabb box_of(const Scene& scene, ObjectId id) {
  if (scene.at(id).placed) return scene.world_box(id);
  const Object& object = scene.at(id);
  const Affine at_origin = world_from_object(Pose{}, object.up, object.scale);
  const Aabb box = object.shape->mesh.box();
  Aabb out;
  for (int i = 0; i < 8; ++i)
    out.extend(at_origin.apply(Vec3((i & 1 ? box.upper : box.lower).x(),
                                    (i & 2 ? box.upper : box.lower).y(),
                                    (i & 4 ? box.upper : box.lower).z())));
  return out;
}

std::vector<std::string> supports_of(const Scene& scene, ObjectId id, const LoadSupport& supports) {
  std::vector<std::string> out;
  for (const LoadSupport::Entry& entry : supports.entries) {
    if (entry.object != id) continue;
    if (entry.on_floor) out.emplace_back(kFloorName);
    for (const ObjectId below : entry.supports) out.push_back(scene.at(below).name);
  }
  return out;
}

// "x 0.1 to 0.2, y ..., z ...".
std::string box_text(const Aabb& box) {
  std::string out;
  for (int i = 0; i < 3; ++i)
    out += std::string(i ? ", " : "") + "xyz"[i] + " " + short_text(box.lower[i]) + " to " +
           short_text(box.upper[i]);
  return out;
}

void add_names(const char* what, const std::vector<std::string>& names, std::string& out) {
  if (!names.empty()) out += std::string(" ") + what + ": " + listed_names(names) + ".";
}

std::string end_text(const std::string& ended) {
  if (ended == "at_rest") return "it came to rest";
  if (ended == "reached") return "it got where it was to go";
  if (ended == "step") return "it stopped at a step that is too high";
  if (ended == "edge") return "it stopped before an edge";
  if (ended == "limit") return "it is at its limit";
  return ended;
}

std::string millimetres(double metres) { return short_text(1000 * metres) + " mm"; }

}  // namespace

std::string point_text(const Vec3& p) {
  return "(" + short_text(p.x()) + ", " + short_text(p.y()) + ", " + short_text(p.z()) + ")";
}

std::string object_line(const Scene& scene, ObjectId id, const LoadSupport& supports) {
  const Object& object = scene.at(id);
  const Aabb box = box_of(scene, id);
  std::string out = quoted(object.name) + ": ";
  if (!object.placed) {
    const Vec3 size = box.upper - box.lower;
    return out + "out of the scene; size " + short_text(size.x()) + " x " + short_text(size.y()) +
           " x " + short_text(size.z()) + " m";
  }
  out += to_string(object.state);
  const std::vector<std::string> below = supports_of(scene, id, supports);
  if (!below.empty() && !object.fixed) out += " on " + listed_names(below);
  return out + "; position " + point_text(object.pose.translation) + "; box " + box_text(box);
}

Json object_data(const Scene& scene, ObjectId id, const LoadSupport& supports) {
  const Object& object = scene.at(id);
  const Aabb box = box_of(scene, id);
  Json out = {{"object", object.name},
              {"model", object.model->path},
              {"state", to_string(object.state)},
              {"lower", {box.lower.x(), box.lower.y(), box.lower.z()}},
              {"upper", {box.upper.x(), box.upper.y(), box.upper.z()}}};
  if (object.placed) {
    const Vec3& t = object.pose.translation;
    const Rotation& r = object.pose.rotation;
    out["position"] = {t.x(), t.y(), t.z()};
    out["rotation"] = {r.w, r.x, r.y, r.z};
    out["on"] = supports_of(scene, id, supports);
  }
  return out;
}

std::string outcome_text(const std::string& what, const Json& answer, const Scene& scene) {
  std::string out = what + ": " + end_text(answer.value("ended", std::string("done")));
  if (answer.contains("blocked_by"))
    out += " by " + quoted(answer["blocked_by"].get<std::string>());
  out += ".";
  if (answer.value("moved", 0.0) > 0)
    out += " It moved by " + short_text(answer["moved"].get<double>()) + " m.";
  if (answer.contains("try"))
    out += " It stands " + short_text(answer["start_shifted"].get<double>()) +
           " m beside what was asked for: there it would not have stood.";
  add_names("Came along", names_in(answer, "carried"), out);
  add_names("Settled after it", names_in(answer, "settled"), out);
  add_names("Gave way", names_in(answer, "gave_way"), out);
  add_names("Nothing holds any more", names_in(answer, "unsupported"), out);
  add_names("It is now in", names_in(answer, "interpenetrates"), out);
  const Json poses = answer.value("poses", Json::array());
  const LoadSupport supports = load_support(scene);
  size_t shown = 0;
  for (const Json& pose : poses) {
    const auto id = scene.find(pose.value("object", std::string()));
    if (!id || shown++ >= kMostNames) continue;
    out += "\n" + object_line(scene, *id, supports);
  }
  if (shown > kMostNames) out += "\nand " + std::to_string(shown - kMostNames) + " more";
  return out;
}

std::string next_step(const std::string& cause) {
  struct Step {
    const char* causes;
    const char* step;
  };
  static constexpr Step kSteps[] = {
      {"unknown_object", "`list` names the objects; `append` brings new ones."},
      {"name_taken invalid_name", "take another name, or `delete` that object."},
      {"fixed", "`unfix` it, or move another object."},
      {"not_placed support_not_placed", "`put` it into the scene."},
      {"crossing inside below_floor touches_at_start float32_contact float32_below_floor",
       "start higher: a greater z in \"position\"; or let a place be found: \"on\": its support."},
      {"topples wedged point_contact rests_on_other rests_too_close leaves_region stands_badly",
       "choose another place: `put` with \"on\" and \"at\": \"anywhere\", or a point farther from "
       "the edge; `look` shows what is there."},
      {"nothing_below no_floor", "choose a position above the floor or above an object."},
      {"no_free_place",
       "make room: a smaller \"keep\", another \"on\", another point in \"at\"; or "
       "`push` or `delete` what stands there."},
      {"keep_too_large", "give a smaller \"keep\"."},
      {"no_arrangement", "leave out or loosen one of the relations that the reason names."},
      {"already_touches nothing_to_slide_on lies_on_nothing no_contact",
       "`list` tells what it lies on; `translate` moves it through the air."},
      {"out_of_time cancelled", "ask for less at once, or again."},
  };
  for (const Step& step : kSteps) {
    const std::string all = std::string(" ") + step.causes + " ";
    if (!cause.empty() && all.find(" " + cause + " ") != all.npos) return step.step;
  }
  return cause.empty() ? "call again with what is accepted." : "`list` and `look` show the scene.";
}

std::string repair_text(const std::string& what, const Json& answer) {
  const Json &moved = answer.at("moved"), &unable = answer.at("unable");
  std::string out = what + ": " + count_of(moved.size(), "object") + " moved";
  if (answer.contains("supports_meant"))
    out += "; " + std::to_string(answer["supports_kept"].get<size_t>()) + " of " +
           std::to_string(answer["supports_meant"].get<size_t>()) + " supports kept";
  out += ".";
  for (size_t i = 0; i < moved.size() && i < kMostNames; ++i)
    out += "\n" + quoted(moved[i]["object"].get<std::string>()) + " by " +
           millimetres(moved[i]["metres"].get<double>()) + " and " +
           short_text(moved[i]["degrees"].get<double>()) + " degrees";
  if (moved.size() > kMostNames)
    out += "\nand " + std::to_string(moved.size() - kMostNames) + " more";
  for (size_t i = 0; i < unable.size() && i < kMostNames; ++i)
    out += "\n" + quoted(unable[i]["object"].get<std::string>()) +
           " stays where it was: " + unable[i]["why"].get<std::string>();
  out += unable.empty() ? "\nNext: `check`, then `save`."
                        : "\nNext: `put` what stays with \"on\" a support, or `delete` it.";
  return out;
}

std::string joint_line(const Json& joint) {
  const std::string unit = joint.at("kind") == "hinge" ? " degrees" : " m";
  std::string out = quoted(joint.at("joint").get<std::string>()) + ": " +
                    joint.at("kind").get<std::string>() + " at " +
                    short_text(joint.at("value").get<double>()) + unit;
  for (const char* const key : {"lower", "upper"})
    if (!joint.at(key).is_null())
      out += std::string(", ") + key + " " + short_text(joint.at(key).get<double>());
  return out;
}

std::string joint_text(const Json& answer) {
  std::string out = joint_line(answer) + "; " + answer.at("end").get<std::string>();
  if (answer.contains("blocked_by"))
    out += " by " + quoted(answer["blocked_by"].get<std::string>());
  out += ".";
  add_names("Came along", names_in(answer, "carried"), out);
  if (answer.contains("blocked_by"))
    out += "\nNext: move what is in the way, or stop before it with \"to\".";
  return out;
}

std::string advice_on(const SceneVerdict& verdict) {
  if (verdict.ok()) return "Next: `save`, or go on.";
  std::vector<std::string> names;
  for (const SceneFinding& finding : verdict.findings)
    if (std::find(names.begin(), names.end(), finding.object) == names.end())
      names.push_back(finding.object);
  return "Next: `mend` moves " + listed_names(names) +
         " to the nearest true places; `undo` takes the last step back.";
}

}  // namespace trivet::mcp
