#include "trivet/operations.h"

#include <atomic>
#include <nlohmann/json.hpp>

#include "apps/library/scene_internal.h"
#include "core/base/bad_input.h"
#include "ops/files/json/operations.h"
#include "trivet/arrange.h"

namespace trivet::v0 {
namespace {

Refusal outer(const trivet::Refusal& refusal) {
  Refusal out;
  out.cause = trivet::to_string(refusal.cause);
  out.message = message(refusal);
  for (const Named& named : refusal.objects) out.objects.push_back(named.name);
  for (const trivet::Refusal::Number& number : refusal.numbers)
    out.numbers.emplace_back(number.key, number.value);
  return out;
}

Result::Status outer(OperationResult::Status status) {
  switch (status) {
    case OperationResult::Status::Ok:
      return Result::Status::Done;
    case OperationResult::Status::Refused:
      return Result::Status::Refused;
    case OperationResult::Status::Cancelled:
      return Result::Status::Cancelled;
    case OperationResult::Status::OutOfTime:
      break;
  }
  return Result::Status::OutOfTime;
}

Result::End outer(OperationResult::End end) {
  switch (end) {
    case OperationResult::End::Done:
      return Result::End::Done;
    case OperationResult::End::AtRest:
      return Result::End::AtRest;
    case OperationResult::End::Reached:
      return Result::End::Reached;
    case OperationResult::End::Blocked:
      return Result::End::Blocked;
    case OperationResult::End::Step:
      return Result::End::Step;
    case OperationResult::End::Edge:
      return Result::End::Edge;
    case OperationResult::End::Limit:
      break;
  }
  return Result::End::Limit;
}

Result outer(const OperationResult& result) {
  Result out;
  out.status = outer(result.status);
  if (result.refusal) out.refusal = outer(*result.refusal);
  out.end = outer(result.end);
  out.blocked_by = result.blocked_by.name;
  out.blocked_at = v0::outer(result.blocked_at);
  out.moved = result.moved, out.turned_deg = result.turned_deg;
  out.motions = result.num_motions, out.milliseconds = result.milliseconds;
  out.carried = result.carried, out.unsupported = result.unsupported;
  out.settled = result.settled, out.interpenetrates = result.interpenetrates;
  for (const trivet::GaveWay& one : result.gave_way)
    out.gave_way.push_back({one.name, one.moved, one.turned_deg});
  return out;
}

template <class T>
auto inner_all(const std::vector<T>& given) {
  std::vector<decltype(inner(given.front()))> out;
  for (const T& one : given) out.push_back(inner(one));
  return out;
}

template <class T>
auto inner_or_none(const std::optional<T>& given) {
  return given ? std::optional(inner(*given)) : std::nullopt;
}

/// Makes the common part of all moves of objects in the scene.
template <class Inner, class Options>
Inner move_of(const Options& options) {
  Inner out;
  out.settle_left = options.settle_left;
  out.together = options.together;
  return out;
}

PutOperation inner(const PutOptions& options) {
  PutOperation out;
  out.start = inner(Pose{options.position, options.rotation});
  out.tries = options.tries, out.within = options.within;
  out.settle_left = options.settle_left;
  return out;
}

PutOperation inner(const PutOnOptions& options) {
  PutOperation out;
  out.start.rotation = inner(options.rotation);
  out.settle_left = options.settle_left;
  PlaceOptions place;
  place.on = options.on;
  place.near = inner_or_none(options.at);
  place.seed = options.seed;
  place.keep = options.keep;
  place.from = options.from;
  place.region = inner_all(options.region);
  place.least_margin = options.least_margin;
  place.most_friction = options.most_friction;
  out.place = std::move(place);
  return out;
}

PushOperation inner(const PushOptions& options) {
  auto out = move_of<PushOperation>(options);
  out.direction = inner(options.direction);
  out.distance = options.distance;
  out.to = inner_or_none(options.to);
  out.via = inner_all(options.via);
  out.step_up = options.step_up, out.step_down = options.step_down;
  out.slide = options.slide, out.settle = options.settle;
  out.normal = inner(options.normal);
  return out;
}

TurnOperation inner(const TurnOptions& options) {
  auto out = move_of<TurnOperation>(options);
  using About = TurnOperation::About;
  out.about = options.about == TurnOptions::About::Normal ? About::Normal
              : options.about == TurnOptions::About::Line ? About::Line
                                                          : About::Point;
  out.with = options.with;
  out.point = inner_or_none(options.point);
  out.centre = inner_or_none(options.centre);
  out.axis = inner_or_none(options.axis);
  out.angle_deg = options.angle_deg;
  out.settle = options.settle;
  return out;
}

PickUpOperation inner(const PickUpOptions& options) {
  auto out = move_of<PickUpOperation>(options);
  out.distance = options.distance;
  out.with = options.with;
  return out;
}

TranslateOperation inner(const TranslateOptions& options) {
  auto out = move_of<TranslateOperation>(options);
  out.by = inner(options.by);
  out.via = inner_all(options.via);
  out.free = options.free, out.settle = options.settle;
  return out;
}

RotateOperation inner(const RotateOptions& options) {
  auto out = move_of<RotateOperation>(options);
  out.axis = inner(options.axis);
  out.angle_deg = options.angle_deg;
  out.centre = inner_or_none(options.centre);
  out.free = options.free, out.settle = options.settle;
  return out;
}

template <class Options>
Result done(Scene& scene, ObjectId object, const Options& options, const Run& run) {
  return guarded([&] {
    auto operation = inner(options);
    operation.object = scene.internal().name(object);
    return scene.internal().perform({std::move(operation)}, run);
  });
}

}  // namespace

struct Cancel::Internal {
  std::atomic<bool> is_requested = false;
};

Cancel::Cancel() : m_internal(std::make_unique<Internal>()) {}
Cancel::~Cancel() = default;
void Cancel::request() noexcept { m_internal->is_requested = true; }

Result Scene::Internal::perform(const std::vector<Operation>& operations, const Run& run) {
  RunContext context;
  context.detector = detector.get();
  if (run.cancel) context.cancel = &run.cancel->internal().is_requested;
  context.time_budget_s = run.max_seconds;
  return outer(m_opened.session.perform_all(operations, settle(), context));
}

Result put(Scene& scene, ObjectId object, const PutOptions& options, const Run& run) {
  return done(scene, object, options, run);
}
Result put_on(Scene& scene, ObjectId object, const PutOnOptions& options, const Run& run) {
  return done(scene, object, options, run);
}
Result push(Scene& scene, ObjectId object, const PushOptions& options, const Run& run) {
  return done(scene, object, options, run);
}
Result turn(Scene& scene, ObjectId object, const TurnOptions& options, const Run& run) {
  return done(scene, object, options, run);
}
Result pick_up(Scene& scene, ObjectId object, const PickUpOptions& options, const Run& run) {
  return done(scene, object, options, run);
}
Result translate(Scene& scene, ObjectId object, const TranslateOptions& options, const Run& run) {
  return done(scene, object, options, run);
}
Result rotate(Scene& scene, ObjectId object, const RotateOptions& options, const Run& run) {
  return done(scene, object, options, run);
}

Result stand(Scene& scene, ObjectId object, const Pose& pose, const Run& run) {
  return guarded([&] {
    StandOperation operation;
    operation.object = scene.internal().name(object);
    operation.pose = inner(pose);
    return scene.internal().perform({operation}, run);
  });
}

Result perform(Scene& scene, const std::string& json, const Run& run) {
  return guarded([&] {
    nlohmann::json document = parse_json(json, "operations");
    if (!document.is_array()) document = nlohmann::json::array({std::move(document)});
    std::vector<Operation> operations;
    for (const JsonPlace& place : JsonPlace(document, "operations").items())
      operations.push_back(read_operation(place));
    if (operations.empty()) bad_input("operations: an empty list; accepted: one at least");
    return scene.internal().perform(operations, run);
  });
}

Result arrange(Scene& scene, const std::string& problem, const Run& run) {
  return guarded([&] {
    nlohmann::json document = parse_json(problem, "arrange");
    if (!document.is_object())
      bad_input("arrange: no JSON object; accepted: the section \"arrange\"");
    document["op"] = "arrange";
    return scene.internal().perform({read_operation(JsonPlace(document, "arrange"))}, run);
  });
}

}  // namespace trivet::v0
