// PUT where there is room: places are proposed by height maps, and PUT decides at each in turn.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/tunables.h"
#include "core/scene/joint.h"
#include "ops/detect/detector.h"
#include "ops/free_places/distance_query.h"
#include "ops/free_places/exact_places.h"
#include "ops/operations/inside.h"
#include "ops/operations/put_parts.h"
#include "ops/placement/coarseness.h"

namespace trivet {
namespace {

using Cause = Refusal::Cause;

constexpr size_t kMaxDoubtful = 1024;  // places at which the distance is measured

/// Search for one object. Plans are pure: no trial touches the scene.
class FreePlaceSearch {
 public:
  FreePlaceSearch(const Scene& scene, ObjectId id, const PutOperation& o, OperationRun& run,
                  const TryCommit& try_commit)
      : m_scene(scene),
        m_id(id),
        m_operation(o),
        m_run(run),
        m_try_commit(try_commit),
        m_name(named(scene, Support(id))),
        m_on(named(scene, o.place->on)),
        m_carried(carried_with(scene, id)) {}

  MovePlan plan() {
    // A request that cannot be met anywhere is refused before any search.
    if (auto why = refuse_request()) return refused(std::move(*why));
    if (!is_on_drawer()) return search();
    // An object put on a drawer lies in it, so that it closes; on its rim if nothing else fits.
    m_inside = true;
    if (MovePlan done = search(); done.result.status != OperationResult::Status::Refused)
      return done;
    m_inside = false;
    m_failures.clear();
    m_num_trials = 0;
    m_first = nullptr;
    return search();
  }

 private:
  bool is_on_drawer() const {
    if (!m_on.support || !m_on.support->is_object()) return false;
    const Object& on = m_scene.at(m_on.support->object());
    return on.joint && !on.joint->turns() && is_container(on);
  }

  MovePlan search() {
    PlaceRequest request = this->request();
    const ExactPlaces exact(m_scene, m_id, m_carried, request, clearance());
    // The point that was asked for comes first, exactly.
    if (request.near && exact.fits(*request.near))
      if (auto done = try_here(exact.start(*request.near))) return std::move(*done);
    Places places;
    // Windows are searched one after the other, each with its places in order.
    for (const PlaceWindow& window :
         place_windows(m_scene, m_id, m_carried, request, clearance())) {
      if (m_num_trials >= kPlaceTrials) break;
      request.within = window;
      places = find_places(m_scene, m_id, m_carried, request, clearance(),
                           drop_brackets_of(m_run.detector));
      auto done = request.near ? try_nearest(places, exact, *request.near, window.reach)
                               : try_all(places, exact);
      if (done) return std::move(*done);
    }
    // On the unbounded floor there is room farther out, unless the scene would get too large.
    const Places beyond = places_beyond(m_scene, m_id, m_carried, request, clearance());
    // Without room anywhere the refusal tells how many places were judged and why they failed.
    if (beyond.starts.empty()) return refused(refuse_everywhere(places));
    m_num_trials = 0;
    auto done = request.near ? try_nearest(beyond, exact, *request.near, kInfinity)
                             : try_all(beyond, exact);
    if (done) return std::move(*done);
    return refused(refuse_everywhere(places));
  }

  MovePlan refused(Refusal why) const {
    MovePlan out;
    out.op = "put";
    out.result.refuse(std::move(why));
    return out;
  }

  std::optional<Refusal> refuse_request() const {
    // A fixed object comes in once, and then stays there.
    const Object& object = m_scene.at(m_id);
    if (!object.fixed || object.placed)
      if (auto why = refuse_immovable(m_scene, m_carried)) return why;
    if (m_on.name == kFloorName) {
      if (!m_scene.floor) return Refusal{Cause::NoFloor, {m_name}};
      return refuse_keep();
    }
    if (!m_on.support) {
      Refusal why = unknown_object(m_scene, m_on.name);
      why.objects.push_back(m_name);
      return why;
    }
    for (const ObjectId id : m_carried)
      if (Support(id) == *m_on.support) return Refusal{Cause::OnItself, {m_name}};
    if (!m_scene.at(m_on.support->object()).placed) return Refusal{Cause::SupportNotPlaced, {m_on}};
    return std::nullopt;
  }

  /// The scene without the object, its loads and its support.
  SceneExtent others() const {
    std::vector<ObjectId> without = m_carried;
    if (m_on.support && m_on.support->is_object()) without.push_back(m_on.support->object());
    return m_scene.extent_without(without);
  }

  // Two bodies at that distance make a scene at least as large.
  std::optional<Refusal> refuse_keep() const {
    const double keep = m_operation.place->keep;
    const SceneExtent others = this->others();
    // Without other objects there is no size to compare with.
    if (others.box.empty()) return std::nullopt;
    const double size = size_of(m_scene.at(m_id));
    const double smallest = std::min(others.smallest_diagonal, size > 0 ? size : kInfinity);
    const double farthest = largest_distance(smallest, m_run.options.clearance);
    if (keep <= farthest) return std::nullopt;
    return Refusal{Cause::KeepTooLarge,
                   {m_name},
                   {{"keep", keep}, {"diagonal", smallest}, {"largest_keep", farthest}}};
  }

  PlaceRequest request() const {
    const PlaceOptions& place = *m_operation.place;
    PlaceRequest out;
    out.on = *m_on.support;
    out.rotation = m_operation.start.rotation;
    out.near = place.near;
    out.seed = place.seed;
    out.keep = others().box.empty() ? 0 : place.keep;
    out.from = place.from;
    out.region = place.region;
    return out;
  }

  double clearance() const {
    const Support on = *m_on.support;
    const double usual = clearance_near(m_scene, m_run.options,
                                        on.is_object() ? m_scene.world_box(on.object()) : Aabb{});
    if (usual > 0) return usual;
    // The first object of the scene.
    const Object& object = m_scene.at(m_id);
    return default_clearance(m_scene, body_of(object, m_operation.start).world_box);
  }

  // The verdict on rest changes slowly from place to place: where it is asked for, every six
  // failures double the way to the next place, up to 32 times.
  bool near_a_failure(const Pose& start, double spacing) const {
    const bool is_slow = is_judged_at_rest(*m_operation.place);
    const int doublings = is_slow ? std::min(m_num_trials / 6, 5) : 0;
    const double distance = std::ldexp(2 * spacing, doublings);
    for (const Vec2& at : m_failures)
      if ((start.translation.head<2>() - at).norm() < distance) return true;
    return false;
  }

  MovePlan put_at(const Pose& start) const {
    // The trial is a PUT from this start, with all its checks.
    PutOperation put = m_operation;
    put.place.reset();
    put.start = start;
    MovePlan plan = plan_put_from_start(
        m_scene, m_id, put, m_run, [this](const MovingGroup& group) { return refuse_end(group); });
    // A wedged end may pass for a PUT that was asked for, but not at a place of ours.
    if (plan.result.ok() && plan.wedged) plan.result.refuse(*plan.wedged);
    if (plan.result.ok() && m_try_commit)
      if (auto why = m_try_commit(plan)) plan.result.refuse(std::move(*why));
    return plan;
  }

  // nullopt: refused there.
  std::optional<MovePlan> try_here(const Pose& start) {
    MovePlan plan = put_at(start);
    if (plan.result.status != OperationResult::Status::Refused) return plan;
    ++m_num_trials;
    if (!m_first) m_first = std::make_shared<const Refusal>(std::move(*plan.result.refusal));
    return std::nullopt;
  }

  std::optional<MovePlan> try_all(const Places& places, const ExactPlaces& exact) {
    const size_t num_doubtful = std::min(places.doubtful.size(), kMaxDoubtful);
    for (size_t k = 0; k < places.starts.size() + num_doubtful; ++k) {
      if (m_num_trials >= kPlaceTrials) break;
      // Doubtful places come last: their distance is measured before they are tried.
      const bool doubtful = k >= places.starts.size();
      const Pose& start = doubtful ? places.doubtful[k - places.starts.size()] : places.starts[k];
      if (near_a_failure(start, places.spacing)) continue;
      if (doubtful && !exact.fits(exact.centre_at(start))) continue;
      if (auto done = try_here(start)) return done;
      m_failures.push_back(start.translation.head<2>());
    }
    return std::nullopt;
  }

  // Nearest to the point where the object can be set down, or, if it does not stay there (it tips
  // over an edge, for example), where it stays.
  std::optional<MovePlan> try_nearest(const Places& places, const ExactPlaces& exact,
                                      const Vec2& near, double reach) {
    // The nearest place that fits is tried first, then others by their distance.
    const std::optional<Vec2> nearest = exact.nearest(places);
    if (!nearest || (*nearest - near).norm() > reach) return std::nullopt;
    if (auto done = try_here(exact.start(*nearest))) return done;
    for (const Pose& start : places.starts.empty() ? places.doubtful : places.starts) {
      const Vec2 at = exact.centre_at(start);
      if (m_num_trials >= kPlaceTrials || (at - near).norm() > reach) break;
      if (near_a_failure(start, places.spacing) || !exact.fits(at)) continue;
      // Between a place where it stays and the point, halving finds the last where it does.
      if (stays_at(start)) return try_here(exact.start(last_to_stay(exact, at, near)));
      ++m_num_trials;
      m_failures.push_back(start.translation.head<2>());
    }
    return std::nullopt;
  }

  bool stays_at(const Pose& start) const {
    return put_at(start).result.status != OperationResult::Status::Refused;
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
  std::optional<Refusal> refuse_end(const MovingGroup& group) const {
    // Contacts with anything else mean that it leans or lies elsewhere.
    for (const GroupContact& touch : group.group_contacts())
      if (touch.with != *m_on.support)
        return Refusal{Cause::RestsOnOther, {m_name, named(m_scene, touch.with)}};
    if (m_inside && !is_inside(group.bodies()[0], body_of(m_scene.at(m_on.support->object()))))
      return Refusal{Cause::RestsOnOther, {m_name, m_on}};
    const double keep = m_operation.place->keep;
    if (!(keep > 0)) return std::nullopt;
    // Distances are measured between surfaces, of the object and of its loads.
    for (const Body& body : group.bodies()) {
      const Neighbours near = group.outside().near(body.world_box, 1.01 * keep);
      for (size_t k = 0; k < near.ids.size(); ++k)
        if (*m_on.support != Support(near.ids[k]) && nearer_than(keep, body, near.bodies[k]))
          return Refusal{Cause::RestsTooClose, {m_name, named(m_scene, Support(near.ids[k]))}};
    }
    return std::nullopt;
  }

  Refusal refuse_everywhere(const Places& places) const {
    const bool has_region = !m_operation.place->region.empty();
    // Places that all lie outside are the region's fault alone.
    if (has_region && places.num_judged == places.num_outside)
      return Refusal{Cause::LeavesRegion, {m_name, m_on}};
    Refusal why{Cause::NoFreePlace, {m_name, m_on}};
    // The counts tell where the search got stuck: outside, beside, blocked, or refused at a trial.
    why.numbers = {{"judged", double(places.num_judged)},
                   {"spacing", places.spacing},
                   {"beside", double(places.num_beside)},
                   {"blocked", double(places.num_blocked)},
                   {"tried", double(m_num_trials)}};
    if (has_region) why.numbers.push_back({"outside", double(places.num_outside)});
    why.first = m_first;
    return why;
  }

  const Scene& m_scene;
  ObjectId m_id;
  const PutOperation& m_operation;
  OperationRun& m_run;
  const TryCommit& m_try_commit;
  Named m_name, m_on;
  std::vector<ObjectId> m_carried;
  std::vector<Vec2> m_failures;
  int m_num_trials = 0;
  bool m_inside = false;                   // only places in the support count
  std::shared_ptr<const Refusal> m_first;  // of the first trial
};

}  // namespace

bool is_judged_at_rest(const PlaceOptions& place) {
  return !place.region.empty() || place.least_margin > 0 || place.most_friction < kInfinity;
}

MovePlan plan_put_where_free(const Scene& scene, ObjectId id, const PutOperation& o,
                             OperationRun& run, const TryCommit& try_commit) {
  return FreePlaceSearch(scene, id, o, run, try_commit).plan();
}

}  // namespace trivet
