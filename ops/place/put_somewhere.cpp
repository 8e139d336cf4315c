// PUT where there is room: places are proposed by height maps, and PUT decides at each in turn.
#include <algorithm>
#include <sstream>
#include <utility>

#include "core/base/tunables.h"
#include "ops/detect/detector.h"
#include "ops/move/moves.h"
#include "ops/place/places.h"
#include "ops/stopwatch.h"

namespace trivet {
namespace {

constexpr const char* kFloorName = "floor";

OperationResult refused(const std::string& reason) {
  OperationResult result;
  result.status = OperationResult::Status::Refused;
  result.reason = reason;
  return result;
}

std::string quoted(const std::string& name) {
  return name == kFloorName ? "the floor" : "\"" + name + "\"";
}

class Somewhere {
 public:
  Somewhere(Scene& scene, ObjectId id, const PutOperation& o, const SettleOptions& options)
      : m_scene(scene),
        m_id(id),
        m_operation(o),
        m_options(options),
        m_name("\"" + std::as_const(scene).at(id).name + "\""),
        m_on(scene.find(o.place->on)) {}

  OperationResult run() {
    const std::string why = why_not_support();
    if (!why.empty()) return refused(why);
    const Places places =
        find_places(m_scene, m_id, request(), clearance(), drop_brackets_of(m_options.detector));
    OperationResult first;
    int num_trials = 0;
    for (const Pose& start : places.starts) {
      if (num_trials == kPlaceTrials) break;
      if (near_a_failure(start, places.spacing)) continue;
      OperationResult result = try_at(start);
      result.milliseconds = m_stopwatch.milliseconds();
      if (result.status != OperationResult::Status::Refused) return result;
      if (num_trials++ == 0) first = std::move(result);
      m_failures.push_back(start.translation.head<2>());
    }
    return refused(why_nowhere(places, num_trials, first.reason));
  }

 private:
  std::string why_not_support() const {
    const std::string& on = m_operation.place->on;
    if (on == kFloorName) return m_scene.floor ? "" : "there is no floor to put " + m_name + " on";
    if (!m_on) return "there is no object " + quoted(on) + " to put " + m_name + " on";
    for (const ObjectId id : carried_with(m_scene, m_id))
      if (id == *m_on) return m_name + " cannot be put on itself or on what it carries";
    if (!std::as_const(m_scene).at(*m_on).placed) return quoted(on) + " is not in the scene";
    return "";
  }

  PlaceRequest request() const {
    const PlaceOptions& place = *m_operation.place;
    PlaceRequest out;
    out.on = m_on;
    out.rotation = m_operation.start.rotation;
    out.near = place.near;
    out.seed = place.seed;
    out.keep = place.keep;
    out.from = place.from;
    return out;
  }

  double clearance() const {
    return m_options.clearance > 0 ? m_options.clearance : default_clearance(m_scene);
  }

  bool near_a_failure(const Pose& start, double spacing) const {
    for (const Vec2& at : m_failures)
      if ((start.translation.head<2>() - at).norm() < 2 * spacing) return true;
    return false;
  }

  OperationResult try_at(const Pose& start) {
    PutOperation put = m_operation;
    put.place.reset();
    put.start = start;
    SettleOptions options = m_options;
    if (options.time_budget_s > 0)
      options.time_budget_s =
          std::max(1e-9, options.time_budget_s - 1e-3 * m_stopwatch.milliseconds());
    return put_from_start(m_scene, m_id, put, options,
                          [this](const MovingGroup& group) { return why_not_there(group); });
  }

  // After it has settled: on the support alone, and as far from everything else as asked for.
  std::string why_not_there(const MovingGroup& group) const {
    const Surroundings& outside = group.outside();
    for (const Touch& touch : group.touches()) {
      const bool floor = touch.outside == ContactsWith::kFloor;
      if (floor ? m_on.has_value() : m_on != outside.ids[touch.outside])
        return m_name + " would come to rest against " + outside.name(m_scene, touch.outside);
    }
    const double keep = m_operation.place->keep;
    if (!(keep > 0)) return "";
    for (const Body& body : group.bodies())
      for (const ContactsWith& c : contacts_with(body, outside.bodies, false, keep, 0))
        if (m_on != outside.ids[c.fixed])
          return m_name + " would come to rest too near to " + outside.name(m_scene, c.fixed);
    return "";
  }

  std::string why_nowhere(const Places& places, int num_trials, const std::string& first) const {
    std::ostringstream out;
    out << "no free place for " << m_name << " on " << quoted(m_operation.place->on) << ": of "
        << places.num_judged << " places, every " << places.spacing << " m, " << places.num_beside
        << " are over no part of it and " << places.num_blocked << " are blocked by other things";
    if (num_trials > 0) out << "; it was tried at " << num_trials << " others: first " << first;
    return out.str();
  }

  Scene& m_scene;
  ObjectId m_id;
  const PutOperation& m_operation;
  const SettleOptions& m_options;
  std::string m_name;
  std::optional<ObjectId> m_on;
  std::vector<Vec2> m_failures;
  Stopwatch m_stopwatch;
};

}  // namespace

OperationResult put_somewhere(Scene& scene, ObjectId id, const PutOperation& o,
                              const SettleOptions& options) {
  return Somewhere(scene, id, o, options).run();
}

}  // namespace trivet
