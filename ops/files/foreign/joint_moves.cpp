#include "ops/files/foreign/joint_moves.h"

#include <algorithm>
#include <cmath>

#include "core/base/bad_input.h"
#include "core/base/quoted.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/operations/carried_with.h"
#include "ops/stability/weight.h"

namespace trivet {
namespace {

Rotation inverse_of(const Rotation& r) { return {r.w, -r.x, -r.y, -r.z}; }

// Joints of links that moved go with them. @param from  pose of such a link before, `to` after.
void carry(const JointToMove& moved, const Pose& from, const Pose& to, OpenedScene& opened) {
  // The turn of the first link is that of all that hang in it.
  const Mat3 turn = (to.rotation * inverse_of(from.rotation)).normalized().matrix();
  for (SceneJoint& joint : opened.joints) {
    // A joint goes along if all of its links did.
    const bool goes =
        joint.name != moved.name &&
        std::all_of(joint.links.begin(), joint.links.end(), [&](ObjectId id) {
          return std::find(moved.links.begin(), moved.links.end(), id) != moved.links.end();
        });
    if (!goes) continue;
    joint.axis = turn * joint.axis;
    joint.anchor = to.translation + turn * (joint.anchor - from.translation);
  }
}

}  // namespace

Scene with_moving_links(const JudgedScene& judged, Scene scene) {
  const PairTable& table = *judged.moving_links;
  scene.pair_rules = table.rules;
  scene.floor_kind = table.floor_kind;
  for (size_t i = 0; i < judged.ids.size(); ++i)
    if (judged.ids[i] && scene.contains(*judged.ids[i]))
      edit_object(scene, *judged.ids[i], [&](Object& o) { o.pair_kind = table.kinds[i]; });
  return scene;
}

SceneJoint& joint_named(OpenedScene& opened, const std::string& name) {
  std::string known;
  for (SceneJoint& joint : opened.joints) {
    if (joint.name == name) return joint;
    known += (known.empty() ? "" : ", ") + trivet::quoted(joint.name);
  }
  bad_file(opened.path, "has no joint %1; accepted: %2", trivet::quoted(name),
           known.empty() ? std::string("none, it has no slides and hinges") : known);
}

double limit_of(const JointToMove& joint, bool upper) {
  const double limit = upper ? joint.upper : joint.lower;
  if (std::isfinite(limit)) return limit;
  bad_input("%1: the joint has no %2 limit; accepted: a number", trivet::quoted(joint.name),
            upper ? "upper" : "lower");
}

Sentence held_joint(const SceneJoint& joint) {
  return say("the joint %1 cannot be moved: %2", trivet::quoted(joint.name), joint.held);
}

JointMove move_joint_of(OpenedScene& opened, SceneJoint& joint, double to, const OperationRun& run,
                        NewPoses& poses) {
  if (!joint.held.empty()) bad_file(opened.path, "%1", held_joint(joint));
  // The links move in a copy, whose rules let neighbours pass as in the other program.
  Scene driven = with_moving_links(opened.judged, opened.judged.scene);
  update_contacts(driven, run.options.clearance, run.options);
  const Pose from = driven.at(joint.links[0]).pose;
  JointMove out = move_joint(driven, joint, to, run);
  // Links and what they carried get their new poses; nothing else has moved.
  for (const std::vector<ObjectId>* ids :
       {&std::as_const(joint.links), &std::as_const(out.carried)})
    for (const ObjectId id : *ids) {
      poses[id] = driven.at(id).pose;
      edit_object(opened.judged.scene, id, [&](Object& o) { o.pose = poses[id]; });
    }
  joint.value = out.value;
  carry(joint, from, driven.at(joint.links[0]).pose, opened);
  return out;
}

std::vector<Sentence> joints_moved_by_contents(const Scene& scene,
                                               const std::vector<SceneJoint>& joints) {
  std::vector<Sentence> out;
  for (const SceneJoint& joint : joints) {
    double links = 0, all = 0;
    for (const ObjectId id :
         carried_with(scene, joint.links[0], std::span(joint.links).subspan(1))) {
      const bool is_link =
          std::find(joint.links.begin(), joint.links.end(), id) != joint.links.end();
      // Links without a mass of the file's have none for its engine.
      if (is_link && !scene.at(id).given_mass) continue;
      const double load = joint_load(joint, scene.at(id).centre_of_mass(), weight_of(scene.at(id)));
      all += load;
      if (is_link) links += load;
    }
    // Readers have told of joints that their links move alone.
    if (moves_joint(joint, joint.friction, links) || !moves_joint(joint, joint.friction, all))
      continue;
    out.push_back(joint.turns
                      ? say("the link in the joint \"%1\" would swing: with what lies on it "
                            "%2 N m turn it",
                            joint.name, figure(all))
                      : say("the link in the joint \"%1\" would slide: with what lies on it "
                            "%2 N pull it",
                            joint.name, figure(all)));
  }
  return out;
}

}  // namespace trivet
