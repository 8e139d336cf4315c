// PUT where there is room: places are proposed by height maps, and PUT decides at each in turn.
#include <algorithm>
#include <sstream>
#include <utility>

#include "core/base/quoted.h"
#include "core/base/tunables.h"
#include "ops/coarseness.h"
#include "ops/detect/detector.h"
#include "ops/move/moves.h"
#include "ops/place/exact_places.h"
#include "ops/place/nearer.h"
#include "ops/stopwatch.h"

namespace trivet {
namespace {

constexpr const char* kFloorName = "floor";
constexpr size_t kMaxDoubtful = 1024;  // places at which the distance is measured

OperationResult refused(const std::string& reason) {
  OperationResult result;
  result.status = OperationResult::Status::Refused;
  result.reason = reason;
  return result;
}

std::string named(const std::string& name) {
  return name == kFloorName ? "the floor" : quoted(name);
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
    const std::string why = why_not();
    if (!why.empty()) return refused(why);
    PlaceRequest request = this->request();
    const ExactPlaces exact(m_scene, m_id, request, clearance());
    if (request.near && exact.fits(*request.near))
      if (auto done = try_here(exact.start(*request.near))) return *done;
    Places places;
    for (const PlaceWindow& window : place_windows(m_scene, m_id, request, clearance())) {
      if (m_num_trials >= kPlaceTrials) break;
      request.within = window;
      places =
          find_places(m_scene, m_id, request, clearance(), drop_brackets_of(m_options.detector));
      auto done = request.near ? try_nearest(places, exact, *request.near, window.reach)
                               : try_all(places, exact);
      if (done) return *done;
    }
    // Where nothing is, there is room, unless the scene would get too large.
    m_num_trials = 0;
    const Places beyond = places_beyond(m_scene, m_id, request, clearance());
    auto done = request.near ? try_nearest(beyond, exact, *request.near, kInfinity)
                             : try_all(beyond, exact);
    if (done) return *done;
    return refused(why_nowhere(places));
  }

 private:
  std::string why_not() const {
    // What is fixed comes in once, and then stands there.
    const Object& object = std::as_const(m_scene).at(m_id);
    const std::string why =
        object.fixed && !object.placed ? "" : why_not_movable(m_scene, carried_with(m_scene, m_id));
    if (!why.empty()) return why;
    const std::string& on = m_operation.place->on;
    if (on == kFloorName && !m_scene.floor) return "there is no floor to put " + m_name + " on";
    if (on == kFloorName) return why_too_far();
    if (!m_on) return "there is no object " + quoted(on) + " to put " + m_name + " on";
    for (const ObjectId id : carried_with(m_scene, m_id))
      if (id == *m_on) return m_name + " cannot be put on itself or on what it carries";
    if (!std::as_const(m_scene).at(*m_on).placed) return quoted(on) + " is not in the scene";
    return "";
  }

  // From which it is to be kept away.
  std::vector<ObjectId> others() const {
    const std::vector<ObjectId> carried = carried_with(m_scene, m_id);
    std::vector<ObjectId> out;
    for (const ObjectId id : m_scene.ids())
      if (std::as_const(m_scene).at(id).placed && m_on != id &&
          std::find(carried.begin(), carried.end(), id) == carried.end())
        out.push_back(id);
    return out;
  }

  // Two bodies at that distance make a scene at least as large.
  std::string why_too_far() const {
    const double keep = m_operation.place->keep;
    std::vector<ObjectId> ids = others();
    if (ids.empty()) return "";
    ids.push_back(m_id);
    double smallest = kInfinity;
    for (const ObjectId id : ids) {
      const Object& object = std::as_const(m_scene).at(id);
      const double diagonal = object.scale * object.shape->box.diagonal();
      if (diagonal > 0) smallest = std::min(smallest, diagonal);
    }
    const double farthest = largest_distance(smallest, m_options.clearance);
    if (keep <= farthest) return "";
    std::ostringstream out;
    out << m_name << " cannot be kept " << keep << " m away from everything else: a scene so large "
        << "is too coarse for its objects, the smallest of which is " << smallest
        << " m; accepted: a distance to keep of up to " << farthest << " m";
    return out.str();
  }

  PlaceRequest request() const {
    const PlaceOptions& place = *m_operation.place;
    PlaceRequest out;
    out.on = m_on;
    out.rotation = m_operation.start.rotation;
    out.near = place.near;
    out.seed = place.seed;
    out.keep = others().empty() ? 0 : place.keep;
    out.from = place.from;
    return out;
  }

  double clearance() const {
    if (m_options.clearance > 0) return m_options.clearance;
    if (const double usual = default_clearance(m_scene); usual > 0) return usual;
    const Object& object = std::as_const(m_scene).at(m_id);  // the first of the scene
    return default_clearance(
        m_scene, Body(*object.shape, world_from_object(m_operation.start, object.up, object.scale))
                     .world_box);
  }

  bool near_a_failure(const Pose& start, double spacing) const {
    for (const Vec2& at : m_failures)
      if ((start.translation.head<2>() - at).norm() < 2 * spacing) return true;
    return false;
  }

  OperationResult put_at(Scene& scene, const Pose& start) const {
    PutOperation put = m_operation;
    put.place.reset();
    put.start = start;
    SettleOptions options = m_options;
    if (options.time_budget_s > 0)
      options.time_budget_s =
          std::max(1e-9, options.time_budget_s - 1e-3 * m_stopwatch.milliseconds());
    return put_from_start(scene, m_id, put, options,
                          [this](const MovingGroup& group) { return why_not_there(group); });
  }

  // Nothing: refused there.
  std::optional<OperationResult> try_here(const Pose& start) {
    OperationResult result = put_at(m_scene, start);
    result.milliseconds = m_stopwatch.milliseconds();
    if (result.status != OperationResult::Status::Refused) return result;
    ++m_num_trials;
    if (m_first_reason.empty()) m_first_reason = result.reason;
    return std::nullopt;
  }

  std::optional<OperationResult> try_all(const Places& places, const ExactPlaces& exact) {
    const size_t num_doubtful = std::min(places.doubtful.size(), kMaxDoubtful);
    for (size_t k = 0; k < places.starts.size() + num_doubtful; ++k) {
      if (m_num_trials >= kPlaceTrials) break;
      const bool doubtful = k >= places.starts.size();
      const Pose& start = doubtful ? places.doubtful[k - places.starts.size()] : places.starts[k];
      if (near_a_failure(start, places.spacing)) continue;
      if (doubtful && !exact.fits(exact.centre_at(start))) continue;
      if (auto done = try_here(start)) return done;
      m_failures.push_back(start.translation.head<2>());
    }
    return std::nullopt;
  }

  // Where the object can be set down nearest to the point, or, if it does not stay there (it tips
  // over an edge, for example), where it stays.
  std::optional<OperationResult> try_nearest(const Places& places, const ExactPlaces& exact,
                                             const Vec2& near, double reach) {
    const std::optional<Vec2> nearest = exact.nearest(places);
    if (!nearest || (*nearest - near).norm() > reach) return std::nullopt;
    if (auto done = try_here(exact.start(*nearest))) return done;
    for (const Pose& start : places.starts.empty() ? places.doubtful : places.starts) {
      const Vec2 at = exact.centre_at(start);
      if (m_num_trials >= kPlaceTrials || (at - near).norm() > reach) break;
      if (near_a_failure(start, places.spacing) || !exact.fits(at)) continue;
      if (stays_at(start)) return try_here(exact.start(last_to_stay(exact, at, near)));
      ++m_num_trials;
      m_failures.push_back(start.translation.head<2>());
    }
    return std::nullopt;
  }

  bool stays_at(const Pose& start) const {
    Scene scene = m_scene;
    return put_at(scene, start).status != OperationResult::Status::Refused;
  }

  // On the line from a place where it stays towards the point.
  Vec2 last_to_stay(const ExactPlaces& exact, const Vec2& from, const Vec2& towards) const {
    Vec2 stays = from, leaves = towards;
    while ((stays - leaves).norm() > exact.tolerance()) {
      const Vec2 middle = 0.5 * (stays + leaves);
      (exact.fits(middle) && stays_at(exact.start(middle)) ? stays : leaves) = middle;
    }
    return stays;
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
      for (size_t k = 0; k < outside.bodies.size(); ++k)
        if (m_on != outside.ids[k] && nearer_than(keep, body, outside.bodies[k]))
          return m_name + " would come to rest too near to " +
                 outside.name(m_scene, static_cast<Index>(k));
    return "";
  }

  std::string why_nowhere(const Places& places) const {
    std::ostringstream out;
    out << "no free place for " << m_name << " on " << named(m_operation.place->on) << ": of "
        << places.num_judged << " places, every " << places.spacing << " m, " << places.num_beside
        << " are over no part of it and " << places.num_blocked << " are blocked by other things";
    if (m_num_trials > 0)
      out << "; it was tried at " << m_num_trials << " others: first " << m_first_reason;
    return out.str();
  }

  Scene& m_scene;
  ObjectId m_id;
  const PutOperation& m_operation;
  const SettleOptions& m_options;
  std::string m_name;
  std::optional<ObjectId> m_on;
  std::vector<Vec2> m_failures;
  int m_num_trials = 0;
  std::string m_first_reason;
  Stopwatch m_stopwatch;
};

}  // namespace

OperationResult put_somewhere(Scene& scene, ObjectId id, const PutOperation& o,
                              const SettleOptions& options) {
  return Somewhere(scene, id, o, options).run();
}

}  // namespace trivet
