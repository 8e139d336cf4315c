// glTF scenes of others: every object may move unless it is said to be fixed.
#include <algorithm>
#include <map>
#include <set>

#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/base/quoted.h"
#include "core/io/overwrites.h"
#include "core/io/process/sandboxed_import.h"
#include "core/io/staged_files.h"
#include "core/io/text/file_bytes.h"
#include "core/scene/transaction.h"
#include "ops/files/foreign/open_scene.h"
#include "ops/files/inplace/scene_objects.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

std::map<std::string, LoadedModel> node_models(const GltfScene& source) {
  std::vector<ModelRequest> requests;
  std::set<std::string> seen;
  for (size_t i = 0; i < source.objects().size(); ++i)
    if (seen.insert(source.model_name(i)).second) requests.push_back({source.model_name(i)});
  const std::vector<LoadedModel> loaded = load_models(requests, source.models(), 1, {});
  std::map<std::string, LoadedModel> out;
  for (size_t i = 0; i < requests.size(); ++i) out[requests[i].name] = loaded[i];
  return out;
}

JudgedScene scene_of(const GltfScene& source, const OpenOptions& options) {
  const std::map<std::string, LoadedModel> models = node_models(source);
  const std::set<std::string> fixed(options.fixed.begin(), options.fixed.end());
  JudgedScene out;
  for (size_t i = 0; i < source.objects().size(); ++i) {
    const SceneNode& node = source.objects()[i];
    const LoadedModel& loaded = models.at(source.model_name(i));
    Object object;
    object.name = node.name;
    object.model = loaded.model;
    object.shape = loaded.shape;
    object.up = UpAxis::Y;
    object.fixed = fixed.count(node.name) > 0 || !node.immovable.empty();
    object.pose = node.pose;
    object.placed = true;
    if (!node.immovable.empty())
      out.notes.push_back(say("\"%1\" stays: %2", node.name, node.immovable));
    out.ids.emplace_back(out.scene.add(std::move(object)));
  }
  return out;
}

void check_names(const GltfScene& source, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (std::none_of(source.objects().begin(), source.objects().end(),
                     [&](const SceneNode& node) { return node.name == name; }))
      bad_file(source.path(), "has no object %1; accepted: names of its nodes", quoted(name));
}

// The floor of the scene is at 0: everything is lifted to it.
void lay_floor(const OpenOptions& options, JudgedScene& judged, std::vector<Sentence>& notes) {
  judged.scene.floor = !options.no_floor;
  if (options.no_floor) return;
  const double height = options.floor.value_or(judged.scene.box().lower.z());
  if (!options.floor)
    notes.push_back(say("the floor is taken to be at the lowest point, %1 m", figure(height)));
  judged.lift = -height + 0.0;
  if (judged.lift == 0) return;
  for (const ObjectId id : judged.scene.ids())
    edit_object(judged.scene, id, [&](Object& o) { o.pose.translation.z() += judged.lift; });
}

void copy_file(const std::string& from, const std::string& to) {
  StagedFiles staged;
  staged.add_copy(to, from);
  staged.commit();
}

}  // namespace

OpenedScene open_gltf_scene(const std::string& path, const OpenOptions& options) {
  auto source = std::make_shared<GltfScene>(path, options.rule, options.limits);
  check_names(*source, options.fixed);
  OpenedScene out;
  out.path = path;
  out.format = "glTF";
  out.judged = scene_of(*source, options);
  lay_floor(options, out.judged, out.notes);
  for (const Sentence& note : out.judged.notes) out.notes.push_back(note);
  if (const auto why = refuse_too_coarse(out.judged.scene, std::span<const PlacedBox>(), 0))
    bad_file(path, message(*why));
  out.write = [source, ids = out.judged.ids, lift = out.judged.lift](const NewPoses& poses,
                                                                     const std::string& target) {
    check_not_the_same(target, {source->path()});
    std::vector<Pose> all;
    bool any = false;
    for (size_t i = 0; i < ids.size(); ++i) {
      all.push_back(source->objects()[i].pose);
      const auto it = poses.find(*ids[i]);
      if (it == poses.end()) continue;
      any = true;
      all[i] = {it->second.rotation, it->second.translation - lift * Vec3::UnitZ()};
    }
    if (!any && lower_extension(target) == lower_extension(source->path()))
      return copy_file(source->path(), target);
    source->move(all);
    source->write(target);
  };
  return out;
}

}  // namespace trivet
