#include "apps/edit/document/results.h"

#include <algorithm>

#include "core/base/quoted.h"
#include "core/base/tunables.h"
#include "ops/files/report/verdict.h"
#include "ops/placement/clearance.h"
#include "ops/placement/neighbourhood.h"

namespace trivet::edit {
namespace {

void add(std::vector<ObjectId>& ids, std::optional<ObjectId> id) {
  if (id && std::find(ids.begin(), ids.end(), *id) == ids.end()) ids.push_back(*id);
}

// True if the objects stand in the way there; others are only named.
bool shows_objects(Refusal::Cause cause) {
  using Cause = Refusal::Cause;
  switch (cause) {
    case Cause::Crossing:
    case Cause::Inside:
    case Cause::Float32Contact:
    case Cause::AlreadyTouches:
    case Cause::Topples:
    case Cause::Wedged:
    case Cause::RestsOnOther:
    case Cause::RestsTooClose:
      return true;
    default:
      return false;
  }
}

// Fixed ones, such as a table, are named, but not lit: they may fill the picture.
void add_objects(const Scene& scene, const Refusal& refusal, std::vector<ObjectId>& ids) {
  if (shows_objects(refusal.cause))
    for (const Named& object : refusal.objects)
      if (object.support && object.support->is_object())
        if (const ObjectId id = object.support->object(); scene.contains(id) && !scene.at(id).fixed)
          add(ids, id);
  if (refusal.first) add_objects(scene, *refusal.first, ids);
}

std::vector<std::string> names_of(const std::vector<GaveWay>& objects) {
  std::vector<std::string> out;
  for (const GaveWay& object : objects) out.push_back(object.name);
  return out;
}

std::string quoted_names(const std::vector<std::string>& names) {
  std::string out;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) out.append(i + 1 < names.size() ? ", " : " and ");
    out.append(quoted(names[i]));
  }
  return out;
}

std::string why_it_ended(const OperationResult& result) {
  const std::string& name = result.blocked_by.name;
  const std::string by = name == "floor" ? std::string("the floor") : quoted_names({name});
  switch (result.end) {
    case OperationResult::End::Blocked:
      return "stopped by " + by;
    case OperationResult::End::Step:
      return "stopped by a step of " + by + " higher than allowed";
    case OperationResult::End::Edge:
      return "stopped before an edge deeper than allowed";
    case OperationResult::End::Done:
    case OperationResult::End::AtRest:
    case OperationResult::End::Reached:
      break;
  }
  return "";
}

// Uses current poses: objects released since may have moved on, so there may be none.
InterferingFaces faces_that_stopped(const Scene& scene, const Operation& operation,
                                    const OperationResult& result, double clearance) {
  std::vector<Placement> moved;
  std::vector<std::string> names = result.carried;
  names.push_back(object_name(operation));
  for (const std::string& name : names)
    if (const auto id = scene.find(name)) moved.push_back({*id, scene.at(*id).pose});
  if (!(clearance > 0)) clearance = default_clearance(scene);
  return blocking_faces(scene, moved, {*result.blocked_by.support, result.blocked_at},
                        kContactTolerance * clearance);
}

void add_sentence(std::string& text, const std::string& sentence) {
  if (!text.empty()) text.append("; ");
  text.append(sentence);
}

}  // namespace

std::optional<Message> message_of(const Scene& scene, const Operation& operation,
                                  const OperationResult& result, double clearance) {
  Message message;
  std::string name = quoted(object_name(operation));
  if (!result.ok()) {
    message.kind = Message::Kind::Refused;
    message.text = result.reason();
    if (result.refusal) add_objects(scene, *result.refusal, message.objects);
    return message;
  }
  std::string what = why_it_ended(result);
  if (!what.empty()) {
    add(message.objects, scene.find(result.blocked_by.name));
    if (result.end != OperationResult::End::Edge) {
      message.points.push_back(result.blocked_at);
      message.faces = faces_that_stopped(scene, operation, result, clearance);
    }
  }
  const std::vector<std::string> gave_way = names_of(result.gave_way);
  if (!gave_way.empty()) add_sentence(what, "gave way: " + gave_way_text(result.gave_way));
  if (!result.unsupported.empty())
    add_sentence(what, quoted_names(result.unsupported) + " left without support");
  if (!result.interpenetrates.empty())
    add_sentence(what, "interpenetrates " + quoted_names(result.interpenetrates));
  if (what.empty()) return std::nullopt;
  if (!result.unsupported.empty() || !result.interpenetrates.empty())
    message.kind = Message::Kind::Warning;
  for (const auto* const names : {&gave_way, &result.unsupported, &result.interpenetrates})
    for (const std::string& other : *names) add(message.objects, scene.find(other));
  message.text = name.append(": ").append(what);
  return message;
}

}  // namespace trivet::edit
