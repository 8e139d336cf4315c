#include "ops/files/inplace/run_in_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/quoted.h"
#include "core/base/tunables.h"
#include "core/exact/interpenetration.h"
#include "core/model/exported_floats.h"
#include "ops/files/json/mass_json.h"
#include "ops/files/json/text.h"
#include "ops/placement/clearance.h"
#include "ops/placement/verify.h"

namespace trivet {
namespace {

constexpr size_t kNamesTold = 20;

[[noreturn]] void fail(const RunOptions& options, const std::string& place, const Sentence& what) {
  throw Error(Error::Kind::BadInput, "%1: %2: %3", options.layout_file, place, what);
}

std::string names_of(const GltfScene& scene) {
  std::string out;
  for (size_t i = 0; i < scene.objects().size() && i < kNamesTold; ++i)
    out += (i ? ", " : "") + quoted(scene.objects()[i].name);
  return out + (scene.objects().size() > kNamesTold ? ", ..." : "");
}

// The layout's entry for each picked object of the scene.
std::map<size_t, const LayoutObject*> picked_objects(const Layout& layout, const GltfScene& scene,
                                                     const RunOptions& options) {
  std::map<std::string, size_t> index_of;
  for (size_t i = 0; i < scene.objects().size(); ++i) index_of[scene.objects()[i].name] = i;
  std::map<size_t, const LayoutObject*> out;
  for (size_t i = 0; i < layout.objects.size(); ++i) {
    const LayoutObject& object = layout.objects[i];
    const std::string place = "/objects/" + std::to_string(i) + "/name";
    const auto found = index_of.find(object.name);
    if (found == index_of.end())
      fail(options, place,
           say("%1 is no object of the scene; accepted: %2", quoted(object.name), names_of(scene)));
    const SceneNode& node = scene.objects()[found->second];
    if (!object.fixed && !node.immovable.empty())
      fail(options, place, say("%1 cannot be moved: %2", quoted(object.name), node.immovable));
    out[found->second] = &object;
  }
  return out;
}

void check_operations(const Layout& layout, const RunOptions& options) {
  for (size_t i = 0; i < layout.operations.size(); ++i) {
    const Operation& o = layout.operations[i];
    if (std::holds_alternative<AppendOperation>(o) ||
        std::holds_alternative<DuplicateOperation>(o) ||
        std::holds_alternative<DrapeOperation>(o) || std::holds_alternative<DeleteOperation>(o) ||
        std::holds_alternative<RenameOperation>(o))
      fail(options, "/operations/" + std::to_string(i) + "/op",
           say("%1 is not accepted: a scene keeps its nodes", quoted(op_name(o))));
    if (std::holds_alternative<FixOperation>(o))
      fail(options, "/operations/" + std::to_string(i) + "/op",
           say("%1 is not accepted: what the layout does not pick stays, and what it picks moves "
               "unless it says \"fixed\"",
               quoted(op_name(o))));
  }
}

Scene make_scene(const Layout& layout, const GltfScene& source,
                 const std::map<size_t, const LayoutObject*>& picked, const RunOptions& options) {
  std::vector<ModelRequest> requests;
  std::map<std::string, size_t> index_of;
  for (size_t i = 0; i < source.objects().size(); ++i)
    if (index_of.emplace(source.model_name(i), requests.size()).second)
      requests.push_back({source.model_name(i)});
  std::vector<LoadedModel> models =
      load_models(requests, source.models(), options.num_threads, options.progress);
  for (LoadedModel& loaded : models) {  // the name was for us alone
    Model model = *loaded.model;
    model.path = source.path();
    loaded.model = std::make_shared<const Model>(std::move(model));
  }
  Scene scene;
  scene.floor = layout.floor;
  scene.floor_material = layout.floor_material.value_or(layout.material);
  for (size_t i = 0; i < source.objects().size(); ++i) {
    const LoadedModel& loaded = models[index_of.at(source.model_name(i))];
    const auto pick = picked.find(i);
    Object object;
    object.name = source.objects()[i].name;
    object.model = loaded.model;
    object.shape = loaded.shape;
    object.up = UpAxis::Y;
    object.fixed = pick == picked.end() || pick->second->fixed;
    object.material = layout.material;
    if (pick != picked.end()) {
      object.material = pick->second->material.value_or(layout.material);
      if (pick->second->mass) give_mass(*pick->second->mass, object);
    }
    object.pose = source.objects()[i].pose;
    object.placed = true;
    scene.add(std::move(object));
  }
  set_pair_rules(layout.pairs, scene);
  return scene;
}

// Ignores findings between objects that were not selected.
void keep_findings_of(const std::set<std::string>& picked, SceneCheck& check) {
  for (auto* findings : {&check.crossings, &check.float32_crossings, &check.contained})
    std::erase_if(*findings, [&](const SceneCheck::PairFinding& f) {
      return !picked.count(f.a) && !picked.count(f.b);
    });
}

/// An object as the written file has it.
struct Written {
  const Object* object;
  bool moved;
  std::vector<Vec3> positions;
  PlacedShape placed;
  Aabb box;
};

// The float32 values of the file itself, of what was moved against everything.
void check_written(const GltfScene& source, const Scene& scene, SceneCheck& check) {
  std::vector<Written> all;
  const std::vector<ObjectId> ids = scene.ids();
  for (size_t i = 0; i < ids.size(); ++i) {
    const Object& object = scene.at(ids[i]);
    all.push_back(
        {&object, source.is_moved(i), source.written_positions(i, object.shape->mesh), {}, {}});
  }
  for (Written& w : all) {
    w.placed = {w.object->shape.get(), &w.positions, w.object->world_from_object(), 0, {}};
    for (size_t v = 0; v < w.positions.size(); ++v) {
      const Vec3 exact = w.placed.world_from_object.apply(w.object->shape->mesh.vertices[v]);
      w.placed.slack = std::max(w.placed.slack, (w.positions[v] - exact).cwiseAbs().maxCoeff());
      w.box.extend(w.positions[v]);
    }
  }
  for (size_t i = 0; i < all.size(); ++i)
    for (size_t j = i + 1; j < all.size(); ++j) {
      if ((!all[i].moved && !all[j].moved) || !overlaps(all[i].box, all[j].box)) continue;
      const auto count = count_crossings(all[i].placed, all[j].placed);
      if (count > 0)
        check.float32_crossings.push_back({all[i].object->name, all[j].object->name, count});
    }
}

// The scene's own nodes place its objects in the world in float32, whose steps grow with
// coordinates: so must the default clearance.
double default_clearance_in_world(const Scene& scene) {
  const ClearanceRange range = clearance_range(scene);
  const double coordinates = kRelativeClearance * scene.box().max_abs_coordinate();
  return std::clamp(coordinates, range.usual, range.largest);
}

}  // namespace

LayoutRun run_in_scene(const Layout& layout, GltfScene& source, const RunOptions& given) {
  RunOptions options = given;
  options.settle = settle_options(given, layout.settle);
  check_operations(layout, options);
  const std::map<size_t, const LayoutObject*> picked = picked_objects(layout, source, options);
  LayoutRun run;
  run.scene = make_scene(layout, source, picked, options);
  if (const double in_world = default_clearance_in_world(run.scene);
      !(options.settle.clearance > 0) && in_world > default_clearance(run.scene))
    options.settle.clearance = in_world;
  if (const auto why =
          refuse_too_coarse(run.scene, std::span<const PlacedBox>(), options.settle.clearance))
    throw Error(Error::Kind::BadInput, "%1: %2", source.path(), message(*why));
  update_contacts(run.scene, options.settle.clearance, options.settle);
  run_operations(layout, options, run);
  finish_run(options, run);
  std::set<std::string> names;
  for (const auto& [index, object] : picked) names.insert(object->name);
  keep_findings_of(names, run.check);
  std::vector<Pose> poses;
  for (const ObjectId id : run.scene.ids()) poses.push_back(std::as_const(run.scene).at(id).pose);
  source.move(poses);
  check_written(source, run.scene, run.check);
  return run;
}

}  // namespace trivet
