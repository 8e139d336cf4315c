#include "apps/farm/scene/make_scene.h"

#include <algorithm>

#include "apps/farm/scene/placing.h"
#include "core/contact/contact_memory.h"
#include "core/model/unit.h"
#include "ops/base/interrupt.h"
#include "ops/base/stopwatch.h"
#include "ops/files/json/operations.h"
#include "ops/operations/perform.h"
#include "ops/settle/program_memory.h"

namespace trivet::farm {
namespace {

/// Thrown out of an attempt.
struct SceneStopped {
  OperationResult::Status end;
};

/// The time that a scene has, all its attempts together.
class SceneClock {
 public:
  explicit SceneClock(const RunContext& context) : m_context(context), m_interrupt(context) {}

  /// With the time that is left, so that an operation ends no sooner than the scene.
  RunContext context() const {
    RunContext out = m_context;
    if (out.time_budget_s > 0)
      out.time_budget_s = std::max(0.0, out.time_budget_s - m_watch.milliseconds() / 1000) + kSlack;
    return out;
  }

  /// To be called after every operation: one that had no time left may have done less, and says so
  /// or not.
  void end_if_over() {
    const auto reason = m_interrupt.reason();
    if (!reason) return;
    throw SceneStopped{*reason == Interrupt::Reason::Cancelled
                           ? OperationResult::Status::Cancelled
                           : OperationResult::Status::OutOfTime};
  }

 private:
  static constexpr double kSlack = 1e-6;  // seconds
  RunContext m_context;
  Interrupt m_interrupt;
  Stopwatch m_watch;
};

/// One attempt at one scene.
class Attempt {
 public:
  Attempt(const SceneSource& source, SceneClock& clock, std::uint64_t k, int attempt)
      : m_source(source), m_recipe(source.recipe), m_clock(clock), m_k(k) {
    m_out.attempt = attempt;
    if (attempt > 0) m_prefix = "attempt " + std::to_string(attempt) + "/";
    m_options.settle.max_motions = m_recipe.max_motions;
    m_options.num_threads = 1;
    m_options.layout_file = "scene " + std::to_string(k);
  }

  MadeScene make();

 private:
  Decision decide(const std::string& name) const { return {m_source.key, m_k, m_prefix + name}; }
  void draw_physics(const PhysicsRanges& ranges, LayoutObject& object) const;
  void draw_objects();
  void do_base();
  Operation with_seed(const Operation& operation, size_t number) const;
  void load(AppendOperation& append) const;
  /// False: the scene is dropped.
  bool put_groups();
  bool put_member(const RecipeGroup& group, const std::string& name);
  PutResult try_to_put(const RecipeGroup& group, const std::string& name, int number);
  void move(const RecipeMove& move, size_t number);
  void drape_over_each(const RecipeMove& move, const std::string& name);
  std::vector<std::string> movable(const std::string& group) const;
  Operation drawn_move(const RecipeMove& move, const std::string& object, Decision& decision) const;
  OperationResult perform(const Operation& operation);
  void record(const Operation& operation, OperationResult result);
  std::string why_refused() const;

  const SceneSource& m_source;
  const Recipe& m_recipe;
  SceneClock& m_clock;
  std::uint64_t m_k;
  std::string m_prefix;
  RunOptions m_options;
  Members m_members;
  MadeScene m_out;
};

void Attempt::draw_physics(const PhysicsRanges& ranges, LayoutObject& object) const {
  const auto draw = [&](const char* what, const std::optional<Interval>& range, double& value) {
    if (range) value = decide(object.name + what).within(*range);
  };
  if (object.material) {
    draw("/friction", ranges.friction, object.material->friction);
    draw("/density", ranges.density, object.material->density);
    draw("/restitution", ranges.restitution, object.material->restitution);
  }
  if (!ranges.kilograms) return;
  object.mass.emplace();
  draw("/mass", ranges.kilograms, object.mass->kilograms);
}

void Attempt::draw_objects() {
  m_out.layout = m_recipe.base;
  m_out.layout.operations.clear();
  for (const RecipeGroup& group : m_recipe.groups) {
    const int count = decide(group.name + "/count").count(group.count);
    std::vector<double> weights;
    weights.reserve(group.models.size());
    for (const RecipeModel& model : group.models) weights.push_back(model.weight);
    std::vector<std::string>& members = m_members[group.name];
    for (int i = 0; i < count; ++i) {
      const std::string name = group.name + "_" + std::to_string(i);
      const RecipeModel& drawn = group.models[decide(name + "/model").weighted(weights)];
      LayoutObject object = drawn.object;
      object.name = name;
      draw_physics(drawn.physics, object);
      const LoadedModel& loaded = m_source.models.at({object.model, object.tessellation});
      object.scale = metres_per_unit(object.scale, loaded.model.get()) *
                     decide(name + "/scale").within(group.scale_range);
      m_out.layout.objects.push_back(std::move(object));
      members.push_back(name);
    }
  }
}

void Attempt::load(AppendOperation& append) const {
  const LoadedModel& loaded = m_source.models.at({append.model, append.tessellation});
  append.model_data = loaded.model;
  append.shape = loaded.shape;
  if (!append.material) append.material = m_recipe.base.material;
}

// An arrangement without a seed is another one in every scene.
Operation Attempt::with_seed(const Operation& operation, size_t number) const {
  if (!std::holds_alternative<ArrangeOperation>(operation)) return operation;
  nlohmann::json document = operation_json(operation);
  if (document.contains("seed")) return operation;
  Decision decision = decide("operation " + std::to_string(number) + "/seed");
  document["seed"] = decision.bits() >> 11;
  return read_operation(JsonPlace(document, m_options.layout_file));
}

void Attempt::do_base() {
  m_out.run.scene = trivet::make_scene(m_out.layout, m_source.models, m_options.layout_file);
  m_options.context = m_clock.context();
  stand_objects(m_out.layout, m_options, m_out.run);
  m_clock.end_if_over();
  for (size_t i = 0; i < m_recipe.base.operations.size(); ++i) {
    Operation operation = with_seed(m_recipe.base.operations[i], i);
    if (auto* append = std::get_if<AppendOperation>(&operation)) load(*append);
    record(operation, perform(operation));
  }
}

OperationResult Attempt::perform(const Operation& operation) {
  return trivet::perform(m_out.run.scene, operation, m_options.settle, m_clock.context());
}

void Attempt::record(const Operation& operation, OperationResult result) {
  m_clock.end_if_over();
  if (result.ok()) m_out.layout.operations.push_back(operation);
  m_out.run.operations.push_back({op_name(operation), object_name(operation), std::move(result)});
}

PutResult Attempt::try_to_put(const RecipeGroup& group, const std::string& name, int number) {
  const std::string prefix = name + (number > 0 ? "/try " + std::to_string(number) : "");
  Decision turn = decide(prefix + "/rotation"), where = decide(prefix + "/place");
  const Rotation rotation = group.rotation == RotationRule::Yaw   ? turn.yaw()
                            : group.rotation == RotationRule::Any ? turn.any_rotation()
                                                                  : group.given;
  const std::optional<Placing> placing =
      draw_placing(m_out.run.scene, group, m_members, name, rotation, where);
  if (!placing) {
    OperationResult result =
        refused({Refusal::Cause::SupportNotPlaced, {{support_names(group), std::nullopt}}});
    m_out.run.operations.push_back({"put", name, result});
    return {result, result.reason()};
  }
  PutResult put = put_by(m_out.run.scene, *placing, m_options.settle, m_clock.context());
  record(placing->put, put.result);
  return put;
}

bool Attempt::put_member(const RecipeGroup& group, const std::string& name) {
  const int tries = m_recipe.on_refusal == OnRefusal::Retry ? m_recipe.tries : 1;
  const size_t num_records = m_out.run.operations.size();
  for (int number = 0; number < tries; ++number) {
    m_out.run.operations.resize(num_records);  // of several tries the last one counts
    const PutResult put = try_to_put(group, name, number);
    if (put.result.ok()) return true;
    m_out.left_out[name] = put.reason;
  }
  return false;
}

bool Attempt::put_groups() {
  for (const RecipeGroup& group : m_recipe.groups)
    for (const std::string& name : m_members[group.name]) {
      if (put_member(group, name))
        m_out.left_out.erase(name);
      else if (m_recipe.on_refusal == OnRefusal::Drop)
        return false;
    }
  return true;
}

std::vector<std::string> Attempt::movable(const std::string& group) const {
  std::vector<std::string> out;
  for (const ObjectId id : m_out.run.scene.ids()) {
    const Object& object = m_out.run.scene.at(id);
    if (!object.placed || object.fixed || object.locked) continue;
    if (group.empty()) {
      out.push_back(object.name);
      continue;
    }
    const std::vector<std::string>& members = m_members.at(group);
    if (std::find(members.begin(), members.end(), object.name) != members.end())
      out.push_back(object.name);
  }
  return out;
}

Operation Attempt::drawn_move(const RecipeMove& move, const std::string& object,
                              Decision& decision) const {
  if (move.kind == RecipeMove::Kind::Turn) {
    TurnOperation turn;
    turn.object = object;
    turn.angle_deg = decision.within(move.angle_deg);
    turn.settle = true;
    return turn;
  }
  PushOperation push;
  push.object = object;
  push.distance = decision.within(move.distance);
  const Rotation yaw = decision.yaw();  // half the direction's angle: w and z are on a circle
  push.direction = {yaw.w, yaw.z};
  return push;
}

// What lies on what is draped over is covered, too.
void Attempt::drape_over_each(const RecipeMove& move, const std::string& name) {
  const std::vector<std::string> objects = movable(move.group);
  for (size_t i = 0; i < objects.size(); ++i) {
    const Scene& scene = m_out.run.scene;
    DrapeOperation sheet = move.sheet;
    sheet.object += "_" + std::to_string(i);
    sheet.start = {decide(name + "/" + std::to_string(i)).yaw(),
                   start_over(scene, objects[i], sheet.size->norm() / 2)};
    record(sheet, perform(sheet));
  }
}

void Attempt::move(const RecipeMove& move, size_t number) {
  const std::string name = "then " + std::to_string(number);
  if (move.kind == RecipeMove::Kind::Drape) return drape_over_each(move, name);
  const int count = decide(name + "/count").count(move.count);
  for (int i = 0; i < count; ++i) {
    const std::vector<std::string> objects = movable(move.group);
    if (objects.empty()) return;
    Decision decision = decide(name + "/" + std::to_string(i));
    const std::string& object = objects[decision.index(objects.size())];
    const Operation operation = drawn_move(move, object, decision);
    record(operation, perform(operation));
  }
}

// Empty: it is accepted.
std::string Attempt::why_refused() const {
  const Acceptance& accept = m_recipe.accept;
  const LayoutRun& run = m_out.run;
  if (!run.check.crossings.empty() || !run.check.float32_crossings.empty() ||
      !run.check.contained.empty())
    return "objects interpenetrate";
  if (!run.check.not_at_rest.empty())
    return "\"" + run.check.not_at_rest.front() + "\" is not at rest";
  int num_placed = 0, num_refused = 0;
  for (const auto& [group, members] : m_members)
    for (const std::string& name : members)
      num_placed += run.scene.at(*run.scene.find(name)).placed ? 1 : 0;
  for (const OperationRecord& record : run.operations) num_refused += record.result.ok() ? 0 : 1;
  if (num_placed < accept.min_objects)
    return std::to_string(num_placed) + " objects; accepted: at least " +
           std::to_string(accept.min_objects);
  if (accept.max_refused && num_refused > *accept.max_refused)
    return std::to_string(num_refused) + " refused operations; accepted: at most " +
           std::to_string(*accept.max_refused);
  if (accept.stable && !run.stability.stable())
    return std::string("it is ") + to_string(run.stability.status) + " as a whole";
  if (run.stability.margin < accept.min_margin) return "its margin to toppling is too small";
  return "";
}

MadeScene Attempt::make() {
  draw_objects();
  m_options.settle = settle_options(m_options, m_recipe.base.settle);
  do_base();
  if (!put_groups()) {
    const auto& [name, why] = *m_out.left_out.begin();
    m_out.reason = "dropped: " + why;
  } else {
    for (size_t i = 0; i < m_recipe.then.size(); ++i) move(m_recipe.then[i], i);
  }
  finish_run(m_options, m_out.run);
  for (OperationRecord& record : m_out.run.operations) record.result.milliseconds = 0;
  if (m_out.reason.empty()) m_out.reason = why_refused();
  m_out.accepted = m_out.reason.empty();
  return std::move(m_out);
}

}  // namespace

MadeScene make_scene(const SceneSource& source, std::uint64_t k) {
  MadeScene out;
  SceneClock clock(source.context);
  const ContactMemory memory;  // what an operation left where it is, the next ones ask for again
  const ProgramMemory programs;
  for (int attempt = 0; attempt < source.recipe.accept.attempts; ++attempt) {
    try {
      out = Attempt(source, clock, k, attempt).make();
    } catch (const SceneStopped& stopped) {
      out.end = stopped.end;
      break;
    }
    if (out.accepted) break;
  }
  return out;
}

}  // namespace trivet::farm
