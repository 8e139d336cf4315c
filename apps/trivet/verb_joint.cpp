// joint: joints of a scene of another program, moved with what lies in and on their links.
#include <cmath>
#include <cstdio>
#include <iostream>

#include "apps/trivet/check_many.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "core/base/quoted.h"
#include "ops/files/foreign/joint_moves.h"
#include "ops/files/foreign/own_joints.h"
#include "ops/files/foreign/repair_json.h"
#include "ops/files/report/scene_file.h"

namespace trivet::apps {
namespace {

struct JointArguments {
  std::string file, joint, to, out;
  std::optional<double> by;
  ForeignArguments foreign;
  SettleArguments settle;
};

std::string number_text(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value == 0 ? 0.0 : value);
  return text;
}

const char* unit_of(const JointToMove& joint) { return joint.turns ? "degrees" : "m"; }

// "0.2 m of 0 to 0.3".
std::string value_text(const JointToMove& joint) {
  std::string out = number_text(joint.value) + " " + unit_of(joint);
  if (joint.lower > -kInfinity || joint.upper < kInfinity)
    out += " of " + number_text(joint.lower) + " to " + number_text(joint.upper);
  return out;
}

int list_joints(const std::string& path, const Scene& scene, const std::vector<SceneJoint>& joints,
                const CommonOptions& common) {
  for (const SceneJoint& joint : joints) {
    if (common.json)
      std::cout << joint_json(scene, joint).dump() << "\n";
    else
      std::cout << trivet::quoted(joint.name) << ": " << (joint.turns ? "hinge" : "slide") << " of "
                << trivet::quoted(scene.at(joint.links[0]).name) << ", at " << value_text(joint)
                << (joint.held.empty() ? "" : "; held: " + in_english(joint.held)) << "\n";
  }
  if (joints.empty() && !common.json && !common.quiet)
    std::cout << path << ": no slides and hinges were read\n";
  return 0;
}

double goal_of(const JointArguments& arguments, const SceneJoint& joint) {
  if (arguments.by) return joint.value + *arguments.by;
  if (arguments.to == "lower" || arguments.to == "upper")
    return limit_of(joint, arguments.to == "upper");
  char* end = nullptr;
  const double value = std::strtod(arguments.to.c_str(), &end);
  if (arguments.to.empty() || *end != 0 || !(std::abs(value) <= kMaxJointValue))
    throw Error(Error::Kind::BadInput, "--to \"%1\"; accepted: a number, \"lower\", \"upper\"",
                arguments.to);
  return value;
}

std::string end_text(const Scene& scene, const JointMove& move) {
  switch (move.end) {
    case JointMove::End::Reached:
      return "reached";
    case JointMove::End::Limit:
      return "stopped at its limit";
    case JointMove::End::Blocked:
      break;
  }
  return "blocked by " + trivet::quoted(named(scene, move.blocker).name);
}

void tell_move(const OpenedScene& opened, const SceneJoint& joint, const JointMove& move,
               const CommonOptions& common) {
  const Scene& scene = opened.judged.scene;
  if (common.json) {
    std::cout << joint_move_json(scene, opened.judged.lift, joint, move).dump() << "\n";
  } else if (!common.quiet) {
    std::cout << trivet::quoted(joint.name) << ": " << end_text(scene, move) << ", at "
              << value_text(joint) << "\n";
    for (const ObjectId id : move.carried)
      std::cout << "  " << trivet::quoted(scene.at(id).name) << " came along\n";
  }
}

int tell_refusal(const SceneJoint& joint, const CommonOptions& common) {
  const std::string why = in_english(held_joint(joint));
  clear_progress_line(common);
  if (common.json)
    std::cout << "{\"status\":\"refused\",\"joint\":" << json_string(joint.name)
              << ",\"reason\":" << json_string(why) << "}\n";
  else
    std::cout << trivet::quoted(joint.name) << ": refused: " << why << "\n";
  return 1;
}

// Joints of a scene of Trivet's are listed alone: to move one is an operation.
int list_own_joints(const JointArguments& arguments, const CommonOptions& common) {
  if (!arguments.joint.empty())
    throw Error(Error::Kind::BadInput,
                "%1: is not a scene of another program; accepted: MJCF, URDF, SDF, USD, and for "
                "scenes of Trivet the verb move-joint",
                arguments.file);
  const SceneFile file = read_scene_file(arguments.file, common.limits());
  return list_joints(arguments.file, file.scene, joints_in(file.scene), common);
}

int move(const JointArguments& arguments, const CommonOptions& common) {
  if (!is_of_others(arguments.file)) return list_own_joints(arguments, common);
  OpenedScene opened = open_scene(arguments.file, open_options(arguments.foreign, common));
  if (arguments.joint.empty())
    return list_joints(opened.path, opened.judged.scene, opened.joints, common);
  SceneJoint& joint = joint_named(opened, arguments.joint);
  if (!joint.held.empty()) return tell_refusal(joint, common);
  const std::unique_ptr<Detector> detector = make_detector(common);
  const RunOptions options = run_options(common, arguments.settle, detector.get());
  const double goal = goal_of(arguments, joint);
  NewPoses poses;
  const JointMove done =
      move_joint_of(opened, joint, goal, OperationRun(options.settle, options.context), poses);
  if (!arguments.out.empty()) opened.write_with_joints(poses, {joint}, arguments.out);
  clear_progress_line(common);
  tell_move(opened, joint, done, common);
  return done.end == JointMove::End::Blocked ? 1 : 0;
}

}  // namespace

std::vector<Verb> add_joint(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand("joint",
                                            "List the joints of a scene, or open and close one of "
                                            "a scene in MJCF, URDF, SDF or USD, with "
                                            "all that lies in and on it, until it meets something");
  const auto arguments = std::make_shared<JointArguments>();
  verb->add_option("file", arguments->file, "A scene in MJCF, URDF, SDF or USD, or of Trivet")
      ->required()
      ->type_name("SCENE");
  verb->add_option("joint", arguments->joint, "Name of the joint; without it all are listed")
      ->type_name("JOINT");
  const auto to = verb->add_option(
      "--to", arguments->to, "Value to move to, metres or degrees, or \"lower\" or \"upper\"");
  verb->add_option("--by", arguments->by, "Metres or degrees to move by")
      ->check(number_from(-kMaxJointValue, kMaxJointValue))
      ->excludes(to);
  verb->add_option(
      "-o,--output", arguments->out,
      "Write the same scene with the joint's new value, and new poses of what came along");
  add_foreign_options(*verb, arguments->foreign);
  add_settle_options(*verb, arguments->settle);
  return {{verb, [arguments, &common] { return move(*arguments, common); },
           "trivet joint kitchen.xml\n"
           "trivet joint kitchen.xml drawer --to upper -o open.xml\n",
           true,
           [arguments] {
             return VerbFiles{{}, {arguments->out}, {arguments->file}};
           }}};
}

}  // namespace trivet::apps
