#include "ops/files/layout/run.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/contact/contact_memory.h"
#include "core/model/unit.h"
#include "core/scene/transaction.h"
#include "ops/files/json/mass_json.h"
#include "ops/files/json/text.h"
#include "ops/files/layout/scene_of_layout.h"
#include "ops/files/layout/watched_run.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "ops/settle/program_memory.h"

namespace trivet {
namespace {

std::string place(const std::string& layout_file, size_t object, const std::string& key = "") {
  return layout_file + ": /objects/" + std::to_string(object) + key;
}

// A model's error gets the place that asked for it.
ModelSource with_place(const Layout& layout, const ModelSource& models, const RunOptions& options) {
  if (options.layout_file.empty()) return models;
  return [&](const std::string& name, const Tessellation& tessellation) {
    try {
      return models(name, tessellation);
    } catch (const Error& e) {
      const auto asks = [&](const LayoutObject& o) {
        return o.model == name && o.tessellation == tessellation;
      };
      const auto judges = [&](const LayoutObject& o) { return o.collision == name; };
      auto it = std::find_if(layout.objects.begin(), layout.objects.end(), asks);
      const char* const key = it == layout.objects.end() ? "/collision" : "/model";
      if (it == layout.objects.end())
        it = std::find_if(layout.objects.begin(), layout.objects.end(), judges);
      const auto index = static_cast<size_t>(it - layout.objects.begin());
      throw Error(e.kind(), "%1: %2", place(options.layout_file, index, key), e.sentence());
    }
  };
}

// Distance that a model reaches from its origin, in units of its file.
double reach_of(const LoadedModel& loaded) {
  return loaded.shape->box.max_abs_coordinate() * std::sqrt(3.0);
}

void check_reach(const LayoutObject& object, double scale, double reach, size_t index,
                 const std::string& layout_file) {
  const double offset = object.pose ? object.pose->translation.cwiseAbs().maxCoeff() : 0;
  const double total = scale * reach + offset;
  if (total <= kMaxLength) return;
  throw Error(Error::Kind::BadInput, "%1: \"%2\" reaches %3 metres; accepted: up to %4",
              place(layout_file, index), object.name, figure(total), figure(kMaxLength));
}

// Links pass through what they hang in.
std::vector<NamedPairRule> pairs_with_joints(const Layout& layout) {
  std::vector<NamedPairRule> out = layout.pairs;
  for (const LayoutObject& object : layout.objects) {
    if (!object.joint) continue;
    NamedPairRule rule{object.name, object.joint->in, {}};
    rule.rule.may_pass = true;
    out.push_back(std::move(rule));
  }
  return out;
}

// @param pose_of  an object of the layout.
template <class PoseOf>
void hang_links(const Layout& layout, Scene& scene, const PoseOf& pose_of) {
  std::map<std::string, const LayoutObject*> named;
  for (const LayoutObject& object : layout.objects) named[object.name] = &object;
  for (const LayoutObject& object : layout.objects) {
    if (!object.joint) continue;
    const LayoutObject& parent = *named.at(object.joint->in);
    hang(scene, *scene.find(object.name), *scene.find(parent.name),
         hung(object.joint->joint, pose_of(parent), pose_of(object)));
  }
}

std::shared_ptr<const Shape> collision_shape(const LayoutObject& object, const LoadedModels& models,
                                             size_t index, const std::string& layout_file) {
  const std::shared_ptr<const Shape>& shape = models.at({object.collision, {}}).shape;
  if (shape->has_faces()) return shape;
  throw Error(Error::Kind::BadInput, "%1: \"%2\" has no triangle; accepted: a mesh",
              place(layout_file, index, "/collision"), object.collision);
}

LoadedModels load_all(const Layout& layout, const ModelSource& models, const RunOptions& options) {
  const std::vector<ModelRequest> requests = model_requests(layout);
  const std::vector<LoadedModel> loaded = load_models(requests, with_place(layout, models, options),
                                                      options.num_threads, options.progress);
  LoadedModels by_request;
  for (size_t i = 0; i < requests.size(); ++i) by_request[requests[i]] = loaded[i];
  return by_request;
}

void report_progress(const RunOptions& options, const std::string& stage, const std::string& item,
                     size_t done, size_t total) {
  if (options.progress) options.progress({stage, item, done, total});
}

void run_operations(const Layout& layout, const RunOptions& options, const RunWatch& watch,
                    LayoutRun& run);

OperationResult not_tried(const OperationRecord& stopped_at) {
  Refusal why{Refusal::Cause::NotTried, {{stopped_at.object, std::nullopt}}};
  why.detail = stopped_at.op;
  return refused(std::move(why));
}

}  // namespace

SettleOptions settle_options(const RunOptions& options, const SettleRules& of_file) {
  return with_rules(with_rules(options.settle, of_file), options.rules);
}

void run_operations(const Layout& layout, const RunOptions& options, LayoutRun& run) {
  run_operations(layout, options, RunWatch{}, run);
}

namespace {

// Clearance of the operation that follows.
double clearance_of_next(const Scene& scene, const Operation& operation) {
  const auto* const put = std::get_if<PutOperation>(&operation);
  const auto id = put ? scene.find(put->object) : std::nullopt;
  return default_clearance(scene, id ? expected_box(scene, scene.at(*id), put->start) : Aabb{});
}

void run_operations(const Layout& layout, const RunOptions& options, const RunWatch& watch,
                    LayoutRun& run) {
  const OperationRecord* stopped_at = nullptr;
  run.operations.reserve(run.operations.size() + layout.operations.size());
  const auto note_refusal = [&] {
    if (!options.stop_at_refusal || stopped_at || run.operations.empty()) return;
    if (!run.operations.back().result.ok()) stopped_at = &run.operations.back();
  };

  note_refusal();
  for (size_t i = 0; i < layout.operations.size(); ++i) {
    const Operation& operation = layout.operations[i];
    const std::string op = op_name(operation), &object = object_name(operation);
    report_progress(options, op, object, i, layout.operations.size());
    run.largest_clearance =
        std::max(run.largest_clearance, clearance_of_next(run.scene, operation));
    OperationResult result = stopped_at
                                 ? not_tried(*stopped_at)
                                 : perform(run.scene, operation, options.settle, options.context);
    if (watch.done) watch.done(run.scene, operation, result);
    run.operations.push_back({op, object, std::move(result)});
    note_refusal();
  }
}

}  // namespace

namespace {

struct Verdict {
  SceneCheck check;
  Stability stability;

  // Scenes of which only single objects are kept at rest need not stand as a whole.
  bool holds(const SettleOptions& settled_by) const {
    return check.whole() && check.not_at_rest.empty() &&
           (!keeps_whole_at_rest(settled_by) || stability.status != Stability::Status::Unstable);
  }
};

void update(const RunOptions& options, double clearance, LayoutRun& run) {
  run.settle = options.settle;
  run.settle.clearance = clearance;
  update_contacts(run.scene, clearance, run.settle);
}

Verdict judge(const RunOptions& options, const LayoutRun& run, const IsOver& is_over) {
  StabilityOptions by = options.stability;
  by.clearance = run.settle.clearance;
  by.is_over = is_over;
  Verdict out;
  out.check =
      check_scene(run.scene, options.num_threads, run.settle.clearance, run.settle, is_over);
  out.stability = options.topples_alone ? toppling(run.scene, by) : stability(run.scene, by);
  return out;
}

// A wider clearance is tried where it may do, as few objects tell soon.
bool may_hold_by(double clearance, const Verdict& narrow, const LayoutRun& run) {
  return clearance > default_clearance(run.scene) && narrow.check.whole() &&
         !narrow.holds(run.settle) && may_rest_by(run.scene, narrow.check, clearance, run.settle);
}

}  // namespace

void finish_run(const RunOptions& options, LayoutRun& run) {
  report_progress(options, "check", "", 0, 1);
  const ContactMemory memory;  // contacts, rest and forces ask for the same pairs
  const ProgramMemory programs;
  const IsOver is_over =
      options.verdict_seconds > 0 ? Deadline(options.verdict_seconds).function() : IsOver();
  const double given = options.settle.clearance;
  update(options, given, run);
  Verdict verdict = judge(options, run, is_over);
  if (given == 0 && !is_time_over(is_over) && may_hold_by(run.largest_clearance, verdict, run)) {
    update(options, run.largest_clearance, run);
    if (Verdict wider = judge(options, run, is_over); wider.holds(run.settle))
      verdict = std::move(wider);
    else
      update(options, given, run);
  }
  run.check = std::move(verdict.check);
  run.stability = std::move(verdict.stability);
  report_progress(options, "check", "", 1, 1);
}

bool LayoutRun::ok() const {
  const auto is_ok = [](const OperationRecord& r) { return r.result.ok(); };
  return std::all_of(operations.begin(), operations.end(), is_ok) && check.ok();
}

std::vector<ModelRequest> model_requests(const Layout& layout) {
  std::vector<ModelRequest> requests;
  std::set<ModelRequest> seen;
  for (const LayoutObject& object : layout.objects) {
    const ModelRequest request{object.model, object.tessellation};
    if (seen.insert(request).second) requests.push_back(request);
    const ModelRequest judged{object.collision, {}};
    if (!object.collision.empty() && seen.insert(judged).second) requests.push_back(judged);
  }
  return requests;
}

Scene make_scene(const Layout& layout, const LoadedModels& models, const std::string& layout_file) {
  Scene scene;
  scene.floor = layout.floor;
  scene.floor_material = layout.floor_material.value_or(layout.material);
  for (size_t i = 0; i < layout.objects.size(); ++i) {
    const LayoutObject& wanted = layout.objects[i];
    LoadedModel loaded = models.at({wanted.model, wanted.tessellation});
    if (!wanted.collision.empty()) loaded.shape = collision_shape(wanted, models, i, layout_file);
    const double scale = metres_per_unit(wanted.scale, loaded.model.get());
    check_reach(wanted, scale, reach_of(loaded), i, layout_file);
    Object object;
    object.name = wanted.name;
    object.model = loaded.model;
    object.shape = loaded.shape;
    object.up = wanted.up.value_or(object.model->up);
    object.scale = scale;
    object.fixed = wanted.fixed || wanted.joint;
    object.material = wanted.material.value_or(layout.material);
    if (wanted.mass) give_mass(*wanted.mass, object);
    scene.add(std::move(object));
  }
  set_pair_rules(pairs_with_joints(layout), scene);
  hang_links(layout, scene, [](const LayoutObject& o) { return *o.pose; });
  return scene;
}

Scene make_scene(const Layout& layout, const ModelSource& models, const RunOptions& options) {
  if (!layout.scene.empty())
    throw Error(Error::Kind::BadInput,
                "%1: /scene: is not accepted here; accepted: layouts of models. Scenes in place "
                "are laid out by trivet run",
                options.layout_file);
  return make_scene(layout, load_all(layout, models, options), options.layout_file);
}

bool stands_as_given(const Layout& layout) {
  return !layout.operations.empty() &&
         std::holds_alternative<RepairOperation>(layout.operations.front());
}

namespace {

// Objects stand where the layout has them, whether they may or not.
void stand_as_given(const Layout& layout, const RunOptions& options, LayoutRun& run) {
  Transaction transaction(run.scene);
  for (const LayoutObject& wanted : layout.objects) {
    if (!wanted.pose) continue;
    transaction.edit(*run.scene.find(wanted.name), [&](Object& object) {
      object.pose = *wanted.pose;
      object.placed = true;
    });
  }
  transaction.commit();
  if (const auto why =
          refuse_too_coarse(run.scene, std::span<const PlacedBox>(), options.settle.clearance))
    throw Error(Error::Kind::BadInput, "%1: %2", options.layout_file, message(*why));
}

}  // namespace

void stand_objects(const Layout& layout, const RunOptions& options, LayoutRun& run) {
  if (stands_as_given(layout)) {
    stand_as_given(layout, options, run);
    return update_contacts(run.scene, options.settle.clearance, options.settle);
  }
  for (size_t i = 0; i < layout.objects.size(); ++i) {
    const LayoutObject& object = layout.objects[i];
    if (!object.pose) continue;
    report_progress(options, "stand", object.name, i, layout.objects.size());
    const ObjectId id = *run.scene.find(object.name);
    OperationResult result = stand(run.scene, id, *object.pose, options.settle);
    if (!result.ok()) run.operations.push_back({"stand", object.name, std::move(result)});
  }
  // Objects that only touched have been moved apart a little.
  const Scene& scene = run.scene;
  hang_links(layout, run.scene, [&](const LayoutObject& o) {
    const Object& object = scene.at(*scene.find(o.name));
    return object.placed ? object.pose : *o.pose;
  });
}

LayoutRun run_layout(const Layout& layout, const ModelSource& models, const RunOptions& options) {
  return run_layout(layout, models, options, RunWatch{});
}

LayoutRun run_layout(const Layout& without_models, const ModelSource& models,
                     const RunOptions& given, const RunWatch& watch) {
  RunOptions options = given;
  options.settle = settle_options(given, without_models.settle);
  LayoutRun run;
  run.scene = make_scene(without_models, models, options);
  Layout layout = without_models;
  for (Operation& operation : layout.operations)
    if (auto* append = std::get_if<AppendOperation>(&operation)) {
      load_model(run.scene, models, *append);
      if (!append->material) append->material = layout.material;
    }
  stand_objects(layout, options, run);
  if (watch.standing) watch.standing(run.scene);
  run_operations(layout, options, watch, run);
  finish_run(options, run);
  return run;
}

Layout without_refused(Layout layout, const LayoutRun& run) {
  // Ahead of the operations there may be refusals to stand.
  const size_t first = run.operations.size() - layout.operations.size();
  std::vector<Operation> done;
  done.reserve(layout.operations.size());
  for (size_t i = 0; i < layout.operations.size(); ++i)
    if (run.operations[first + i].result.ok()) done.push_back(std::move(layout.operations[i]));
  layout.operations = std::move(done);
  return layout;
}

LayoutRun run_start_only(const Layout& layout, const ModelSource& models, const RunOptions& given) {
  RunOptions options = given;
  options.settle = settle_options(given, layout.settle);
  LayoutRun run;
  run.scene = make_scene(layout, models, options);
  stand_as_given(layout, options, run);
  finish_run(options, run);
  return run;
}

}  // namespace trivet
