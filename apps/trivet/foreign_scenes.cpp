#include "apps/trivet/foreign_scenes.h"

#include "core/base/extension.h"
#include "ops/files/report/scene_file.h"

namespace trivet::apps {

void add_foreign_options(CLI::App& app, ForeignArguments& arguments) {
  const std::string group = "Scenes of other programs";
  app.add_option("--key", arguments.key,
                 "Keyframe of MJCF with the poses; \"none\": where the bodies stand; a file .npy "
                 "with an array "
                 "of qpos; default: the first keyframe, if it has positions")
      ->group(group);
  app.add_option(
         "--collide", arguments.collide,
         "Shapes of colliding meshes: engine, their convex hulls, as engines take them; raw, "
         "as they are")
      ->check(one_of({"engine", "raw"}))
      ->group(group);
  app.add_option(
         "--rules", arguments.rules,
         "Engine by whose rule the friction of two surfaces counts: mujoco, the larger one, "
         "or that of the higher priority; bullet, their product; gazebo and trivet, the "
         "smaller one; format, that of the format's own engine")
      ->check(one_of(rules_names()))
      ->group(group);
  app.add_option("--root", arguments.roots,
                 "Folders, besides that of the scene, whose files a scene may name")
      ->group(group);
  app.add_option("--objects", arguments.rule,
                 "Nodes of glTF that are objects, as a layout's \"scene_objects\"")
      ->check(one_of({"roots", "groups", "meshes"}))
      ->group(group);
  app.add_option("--fixed", arguments.fixed, "Objects of glTF that never move")->group(group);
  app.add_option("--floor", arguments.floor,
                 "Height of the floor of glTF, metres; default: the lowest point of the scene")
      ->check(number_from(-1e6, 1e6))
      ->group(group);
  app.add_flag("--no-floor", arguments.no_floor, "No floor under glTF")->group(group);
  app.add_flag("--free-base", arguments.free_base, "The root link of URDF may move")->group(group);
}

OpenOptions open_options(const ForeignArguments& arguments, const CommonOptions& common) {
  OpenOptions out;
  out.limits = common.limits();
  if (!arguments.key.empty()) out.foreign.key = arguments.key;
  out.foreign.true_meshes = arguments.collide == "raw";
  out.foreign.rules = *rules_of(arguments.rules);
  out.foreign.fixed_base = !arguments.free_base;
  out.foreign.roots = arguments.roots;
  out.fixed = arguments.fixed;
  out.floor = arguments.floor;
  out.no_floor = arguments.no_floor;
  if (arguments.rule == "groups") out.rule = SceneRule::Groups;
  if (arguments.rule == "meshes") out.rule = SceneRule::Meshes;
  return out;
}

bool is_of_others(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".glb" || extension == ".gltf") return !is_scene_file(path);
  // Binary USD is refused with what to do.
  if (extension == ".usdc" || extension == ".usdz") return true;
  return extension != ".json" && is_scene_of_others(path);
}

}  // namespace trivet::apps
