#include "ops/files/foreign/open_scene.h"

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/io/foreign/joint_values.h"
#include "core/io/foreign/mjcf/qpos_array.h"
#include "core/io/foreign/mjcf/read_mjcf.h"
#include "core/io/foreign/sdf.h"
#include "core/io/foreign/urdf.h"
#include "core/io/foreign/usd/read_usda.h"
#include "core/io/foreign/write_back.h"
#include "core/io/overwrites.h"
#include "core/io/process/sandboxed_import.h"
#include "core/io/staged_files.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSceneTags =
    "<mujoco> (MJCF), <robot> (URDF) or <sdf> (SDF) as the first element, or USD as text";

/// A format of scenes.
struct SceneFormat {
  const char* name;
  const char* tag;  // first element; "": none, it is no XML
  std::vector<std::string> extensions;
  ForeignScene (*read)(const std::string&, const ForeignOptions&, const MeshSource&);
};

const std::vector<SceneFormat>& scene_formats_of_others() {
  static const std::vector<SceneFormat> formats = {
      {"MJCF", "mujoco", {".xml", ".mjcf"}, read_mjcf},
      {"URDF", "robot", {".urdf"}, read_urdf},
      {"SDF", "sdf", {".sdf", ".world"}, read_sdf},
      {"USD", "", {".usda", ".usd"}, read_usda},
  };
  return formats;
}

bool is_gltf(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".glb" || extension == ".gltf";
}

bool is_binary_usd(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".usdc" || extension == ".usdz";
}

bool has_extension_of(const SceneFormat& format, const std::string& path) {
  const auto& all = format.extensions;
  return std::find(all.begin(), all.end(), lower_extension(path)) != all.end();
}

// XML by its first element, whatever the file is called.
ForeignScene read_as_it_is(const std::string& path, const ForeignOptions& options,
                           const MeshSource& meshes) {
  if (is_binary_usd(path))
    bad_file(path, "is binary USD; accepted: USD as text (usdcat %1 -o scene.usda)", path);
  for (const SceneFormat& format : scene_formats_of_others())
    if (*format.tag == 0 && has_extension_of(format, path))
      return format.read(path, options, meshes);
  std::vector<XmlFile> files;
  const std::string tag = read_xml_tree(path, 0, options.limits, files).tag;
  for (const SceneFormat& format : scene_formats_of_others())
    if (tag == format.tag) return format.read(path, options, meshes);
  bad_file(path, "begins with <%1>; accepted: %2", tag, kSceneTags);
}

ForeignScene read_scene_file(const std::string& path, const ForeignOptions& options,
                             const MeshSource& meshes) {
  ForeignScene out = read_as_it_is(path, options, meshes);
  refine_balls(out);
  return out;
}

// Where a file of the scene goes when the main one is written as `out`. What the scene names must
// not decide about files elsewhere.
std::string target_of(const ForeignScene& scene, size_t file, const std::string& out) {
  if (file == 0) return out;
  const fs::path from = fs::absolute(scene.files[0].path).parent_path();
  const fs::path relative = fs::absolute(scene.files[file].path).lexically_relative(from);
  if (relative.empty() || *relative.begin() == "..")
    bad_file(scene.files[file].path,
             "is outside the folder of the scene, and would be written outside that of the output; "
             "accepted: an output in the scene's folder, if nothing changes in this file");
  return (fs::absolute(out).parent_path() / relative).lexically_normal().string();
}

// True if the output lies where the scene lies: it then names the same files.
bool is_named_from(const ForeignScene& scene, const std::string& out) {
  std::error_code error;
  const fs::path from = fs::absolute(scene.files[0].path).parent_path();
  return fs::equivalent(from, fs::absolute(out).parent_path(), error);
}

// Bases that collide, each with all that hangs in it.
std::vector<std::vector<ObjectId>> standing_of(const ForeignScene& foreign,
                                               const JudgedScene& judged) {
  std::map<int, int> parent;  // of welds
  for (const ForeignBody& body : foreign.bodies) parent[body.weld] = body.parent_weld;
  const auto root_of = [&](int weld) {
    // Files may close circles: the way up ends by its length.
    for (size_t steps = 0; steps < parent.size() && parent.count(weld); ++steps) {
      const int above = parent.at(weld);
      if (above < 0) return weld;
      weld = above;
    }
    return -1;
  };
  std::map<int, std::vector<ObjectId>> by_root;
  for (size_t i = 0; i < foreign.bodies.size(); ++i)
    if (foreign.bodies[i].is_base && judged.ids[i])
      by_root[foreign.bodies[i].weld] = {*judged.ids[i]};
  for (size_t i = 0; i < foreign.bodies.size(); ++i) {
    if (!judged.ids[i] || foreign.bodies[i].is_base || !foreign.bodies[i].is_link) continue;
    const auto found = by_root.find(root_of(foreign.bodies[i].weld));
    if (found != by_root.end()) found->second.push_back(*judged.ids[i]);
  }
  std::vector<std::vector<ObjectId>> out;
  out.reserve(by_root.size());
  for (auto& [weld, ids] : by_root) out.push_back(std::move(ids));
  return out;
}

std::vector<SceneJoint> joints_of(const ForeignScene& foreign, const JudgedScene& judged) {
  std::vector<SceneJoint> out;
  for (const ForeignJoint& joint : foreign.joints) {
    SceneJoint mine;
    mine.name = joint.name;
    mine.turns = joint.kind == ForeignJoint::Kind::Hinge;
    mine.axis = joint.axis;
    mine.anchor = joint.anchor + judged.lift * Vec3::UnitZ();
    mine.value = joint.value, mine.lower = joint.lower, mine.upper = joint.upper;
    mine.number = joint.number, mine.held = joint.held;
    for (const std::string& name : joint.moves)
      if (const auto id = judged.scene.find(name)) mine.links.push_back(*id);
    for (const std::string& name : joint.frames)
      if (const auto id = judged.scene.find(name)) mine.frames.push_back(*id);
    mine.friction = joint.friction;
    if (!mine.links.empty()) out.push_back(std::move(mine));
  }
  return out;
}

// Files have angles in radians.
JointNumbers numbers_of(const std::vector<SceneJoint>& joints) {
  JointNumbers out;
  for (const SceneJoint& joint : joints)
    out[joint.number] = joint.turns ? joint.value * (std::numbers::pi / 180) : joint.value;
  return out;
}

// The values of all joints that have one of their own; those in `changed` are new.
JointValues values_of(const ForeignScene& scene, const JointNumbers& changed) {
  JointValues out;
  for (const ForeignJoint& joint : scene.joints) {
    if (!joint.held.empty()) continue;
    const bool turns = joint.kind == ForeignJoint::Kind::Hinge;
    const auto it = changed.find(joint.number);
    out[joint.name] = it != changed.end() ? it->second
                      : turns             ? joint.value * (std::numbers::pi / 180)
                                          : joint.value;
  }
  return out;
}

// Values that no longer hold would be read with the new file: they are replaced.
bool needs_values(const ForeignScene& scene, const JointNumbers& changed, const std::string& path) {
  std::error_code error;
  return !changed.empty() || !scene.values_file.empty() || fs::exists(path, error);
}

// The scene's layers stay as they are: a new one lies over them.
void write_over_layer(const ForeignScene& scene, const std::map<size_t, Pose>& poses,
                      const std::string& out) {
  if (lower_extension(out) != ".usda")
    bad_file(out, "is no name for a layer over a scene of USD; accepted: .usda");
  std::vector<std::string> inputs;
  for (const XmlFile& file : scene.files) inputs.push_back(file.path);
  check_not_the_same(out, inputs);
  std::string below = fs::absolute(scene.files[0].path)
                          .lexically_relative(fs::absolute(out).parent_path())
                          .generic_string();
  if (!below.starts_with("..")) below = "./" + below;
  StagedFiles staged;
  staged.add(out, usda_over_layer(scene, poses, below));
  staged.commit();
}

std::vector<std::string> inputs_of(const ForeignScene& scene) {
  std::vector<std::string> out;
  for (const XmlFile& file : scene.files) out.push_back(file.path);
  for (const std::string& file : {scene.values_file, scene.numbers_file})
    if (!file.empty()) out.push_back(file);
  return out;
}

// The numbers of all joints alone.
void write_numbers(const ForeignScene& scene, const std::map<size_t, Pose>& poses,
                   const JointNumbers& joints, const std::string& out) {
  if (scene.format != "MJCF")
    bad_file(out, "cannot hold poses of %1; accepted: numbers of joints of MJCF", scene.format);
  check_not_the_same(out, inputs_of(scene));
  StagedFiles staged;
  staged.add(out, qpos_array(numbers_with_poses(scene, poses, joints)));
  staged.commit();
}

// XML under the name of another format would be read as that.
void refuse_other_format(const ForeignScene& scene, const std::string& out) {
  const auto& formats = scene_formats_of_others();
  const auto mine = std::find_if(formats.begin(), formats.end(),
                                 [&](const SceneFormat& f) { return scene.format == f.name; });
  const bool as_read = lower_extension(out) == lower_extension(scene.files[0].path);
  if (as_read || !is_scene_of_others(out) || has_extension_of(*mine, out)) return;
  std::string accepted;
  for (const std::string& extension : mine->extensions)
    accepted += (accepted.empty() ? "" : ", ") + extension;
  bad_file(out, "would hold %1; accepted: %2", scene.format, accepted);
}

void write_files(const ForeignScene& scene, const std::map<size_t, Pose>& poses,
                 const JointNumbers& joints, const std::string& out) {
  if (is_qpos_array(out)) return write_numbers(scene, poses, joints, out);
  if (!scene.numbers_file.empty())
    bad_file(out, "is no place for poses that %1 has; accepted: .npy", scene.numbers_file);
  if (scene.usda) return write_over_layer(scene, poses, out);
  refuse_other_format(scene, out);
  const bool apart = scene.format != "MJCF";
  const std::vector<std::string> bytes =
      files_with_poses(scene, poses, apart ? JointNumbers() : joints);
  const std::vector<std::string> inputs = inputs_of(scene);
  StagedFiles staged;
  if (const std::string values = joint_values_path(out);
      apart && needs_values(scene, joints, values)) {
    check_not_the_same(values, inputs);
    staged.add(values, joint_values_text(values_of(scene, joints)));
  }
  for (size_t i = bytes.size(); i-- > 0;) {  // the main file names the others: it comes last
    if (i > 0 && bytes[i] == scene.files[i].bytes && is_named_from(scene, out)) continue;
    const std::string target = target_of(scene, i, out);
    check_not_the_same(target, inputs);
    staged.add(target, bytes[i]);
  }
  staged.commit();
}

}  // namespace

bool is_scene_of_others(const std::string& path) {
  const auto& formats = scene_formats_of_others();
  return is_gltf(path) ||
         std::any_of(formats.begin(), formats.end(),
                     [&](const SceneFormat& format) { return has_extension_of(format, path); });
}

OpenedScene open_scene(const std::string& path, const OpenOptions& options) {
  if (is_gltf(path)) return open_gltf_scene(path, options);
  const SharedImporters importers;
  const MeshSource meshes = [&](const std::string& file) {
    return import_model(file, options.limits);
  };
  ForeignScene read = read_scene_file(path, options.foreign, meshes);
  apply_rules(options.foreign.rules, read);
  const auto foreign = std::make_shared<const ForeignScene>(std::move(read));
  OpenedScene out;
  out.path = path, out.format = foreign->format, out.key = foreign->key;
  out.notes = foreign->notes, out.unread = foreign->unread;
  if (!foreign->values_file.empty())
    out.notes.push_back(say("the values of joints are those of %1", foreign->values_file));
  out.num_joints = foreign->num_joints;
  for (const XmlFile& file : foreign->files) out.files.push_back(file.path);
  if (!foreign->values_file.empty()) out.files.push_back(foreign->values_file);
  if (!foreign->numbers_file.empty()) out.files.push_back(foreign->numbers_file);
  out.judged = judged_scene(*foreign);
  out.joints = joints_of(*foreign, out.judged);
  out.standing = standing_of(*foreign, out.judged);
  for (const Sentence& note : out.judged.notes) out.notes.push_back(note);
  out.write_with_joints = [foreign, ids = out.judged.ids, lift = out.judged.lift](
                              const NewPoses& poses, const std::vector<SceneJoint>& moved,
                              const std::string& target) {
    std::map<size_t, Pose> by_body;
    for (size_t i = 0; i < ids.size(); ++i)
      // Links stand where their joints have them; USD has their poses, too.
      if (ids[i] && (foreign->usda || !foreign->bodies[i].is_link))
        if (const auto it = poses.find(*ids[i]); it != poses.end())
          by_body[i] = {it->second.rotation, it->second.translation - lift * Vec3::UnitZ()};
    write_files(*foreign, by_body, numbers_of(moved), target);
  };
  out.write = [write = out.write_with_joints](const NewPoses& poses, const std::string& target) {
    write(poses, {}, target);
  };
  return out;
}

}  // namespace trivet
