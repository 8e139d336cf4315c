#include "ops/mend/in_place.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/io/foreign/scene.h"
#include "ops/check/check.h"
#include "ops/mend/attitudes.h"
#include "ops/mend/close_gaps.h"
#include "ops/mend/part_by_turns.h"
#include "ops/mend/rearrange.h"
#include "ops/mend/rest_near.h"
#include "ops/mend/rows.h"
#include "ops/mend/starts.h"
#include "ops/mend/starts_in_place.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

constexpr double kReachOfClosing = 2;  // tolerances
constexpr double kMostReach = 0.04;    // metres: what is farther falls
// Metres, of closing gaps: the first ones do mostly.
constexpr double kMostSteps[] = {0.006, 0.004, kInfinity};
constexpr double kFarInHeap = 4;  // median ways
// Tolerances within which an object has to come to rest, round by round.
constexpr double kFarthestInPlace[] = {2, 4, 1e9};
constexpr size_t kLeastOfHeap = 2;
constexpr double kTiltedShareOfHeap = 0.15;
constexpr double kNearInPlace = 0.7;  // tolerances: near enough to look no further
constexpr double kNearAtRest = 2;     // the same of what contacts hold as it lies
constexpr double kRadiansOfDegree = 3.14159265358979323846 / 180;

class HeapInPlace {
 public:
  HeapInPlace(Scene& scene, const MendOptions& options, const Deadline& deadline,
              const Intent& meant, const std::vector<ObjectId>& order)
      : m_scene(scene), m_meant(meant), m_order(order), m_out(scene, options, deadline, order) {}

  SettledScene run() {
    hold_parted();
    if (!m_out.is_out_of_time()) close_all();
    if (!m_out.is_out_of_time()) come_to_rest();
    // The others are let go one by one, at first only where they come to rest near.
    for (const double farthest : kFarthestInPlace)
      for (const ObjectId id : m_order)
        if (is_held(id) && !m_out.is_out_of_time()) let_go(id, farthest * tolerance());
    hold_what_does_not_rest();
    for (const ObjectId id : m_order)
      if (is_held(id)) give_up(id);
    return m_out.finish();
  }

 private:
  static bool contains(const std::vector<ObjectId>& ids, ObjectId id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  }

  /// Result of closing gaps by steps of one length.
  struct Attempt {
    std::vector<ObjectId> missing;  // that nothing holds
    double way = kInfinity;         // square metres, of all
    bool any_is_far = true;
    Scene scene;

    bool is_good() const { return missing.empty() && !any_is_far; }
    bool is_better_than(const Attempt& other) const {
      return std::pair(missing.size(), way) < std::pair(other.missing.size(), other.way);
    }
  };

  // All come into the contacts that hold them.
  void close_all() {
    const Scene parted = m_scene;
    Attempt best = attempt(kMostSteps[0]);
    std::vector<double> longest{m_longest_step};  // of each attempt
    // Bodies that nothing held at first have moved others, until these did.
    if (!best.is_good() && !m_missed.empty() && !m_out.is_out_of_time()) {
      m_scene = parted;
      let_go_first(std::exchange(m_missed, {}));
      Attempt other = attempt(kMostSteps[0]);
      m_aims.clear();
      if (other.is_better_than(best)) best = std::move(other);
    }
    for (size_t k = 1; k < std::size(kMostSteps) && !best.is_good() && !m_out.is_out_of_time();
         ++k) {
      // An attempt of which no step met either bound would go as it did.
      bool is_known = false;
      for (size_t j = 0; j < k; ++j)
        is_known |= longest[j] <= std::min(kMostSteps[j], kMostSteps[k]);
      longest.push_back(kInfinity);
      if (is_known) continue;
      m_scene = parted;
      Attempt other = attempt(kMostSteps[k]);
      longest.back() = m_longest_step;
      if (other.is_better_than(best)) best = std::move(other);
    }
    m_scene = best.scene;
  }

  // The others then move as little as can be, where these come to rest near.
  void let_go_first(const std::vector<ObjectId>& ids) {
    for (const ObjectId id : m_order) hold(id, m_scene.at(id).pose);
    for (const ObjectId id : ids) {
      let_go(id, kFarthestInPlace[0] * tolerance());
      if (!is_held(id)) m_aims[id.index] = m_scene.at(id).pose;
      hold(id, m_scene.at(id).pose);
    }
  }

  // Bodies that no contact within reach would hold come alone, as long as fewer are missing then.
  std::vector<ObjectId> let_go_missing(std::vector<ObjectId> missing) {
    for (size_t before = missing.size() + 1;
         !missing.empty() && missing.size() < before && !m_out.is_out_of_time();) {
      before = missing.size();
      for (const ObjectId id : m_order) hold(id, m_scene.at(id).pose);
      for (const ObjectId id : missing) let_go_alone(id);
      // Back at its given pose what was let go would be missed again.
      missing = close(kMostSteps[0], false);
    }
    return missing;
  }

  // If anything is missing, on from there, and once more with the given poses as aims.
  Attempt attempt(double most_step) {
    m_longest_step = 0;
    m_missed.clear();
    std::vector<ObjectId> missing = close(most_step);
    for (const bool near_given : {false, true})
      if (!missing.empty() && !m_out.is_out_of_time()) missing = close(most_step, near_given);
    missing = let_go_missing(std::move(missing));
    return {std::move(missing), squared_ways(), any_is_far(), m_scene};
  }

  // @return those that nothing holds.
  std::vector<ObjectId> close(double most_step, bool near_given = true) {
    const double clearance = clearance_of(m_scene, m_out.options().settle);
    const double reach = std::min(kReachOfClosing * tolerance(), kMostReach);
    std::vector<Placement> given;
    given.reserve(m_order.size());
    for (const ObjectId id : m_order) {
      const auto aim = m_aims.find(id.index);
      given.push_back({id, aim == m_aims.end() ? m_out.given(id) : aim->second});
    }
    if (!m_known) m_known.emplace(reach, clearance);
    for (const ObjectId id : m_order) release(id);
    const auto is_over = [this] { return m_out.is_out_of_time(); };
    ClosedGaps closed =
        close_gaps(m_scene, given, {clearance, reach, most_step, near_given, is_over, &*m_known});
    m_longest_step = std::max(m_longest_step, closed.longest_step);
    if (near_given)
      for (const ObjectId id : closed.missed)
        if (!contains(m_missed, id)) m_missed.push_back(id);
    return std::move(closed.not_held);
  }

  std::vector<double> ways() const {
    std::vector<double> out;
    out.reserve(m_order.size());
    for (const ObjectId id : m_order) out.push_back(way_to(id, m_scene.at(id).pose));
    return out;
  }
  double squared_ways() const {
    double out = 0;
    for (const double way : ways()) out += way * way;
    return out;
  }
  // A wrong contact has dragged it along.
  bool any_is_far() const {
    std::vector<double> sorted = ways();
    std::sort(sorted.begin(), sorted.end());
    return sorted.back() > kFarInHeap * sorted[sorted.size() / 2];
  }

  // A body that falls as the whole comes to rest is missed by it, as one that nothing holds.
  void come_to_rest() {
    const Scene closed = m_scene;
    hold_what_does_not_rest();
    const std::vector<ObjectId> fallen = gone_since(closed, tolerance());
    if (fallen.empty() || m_out.is_out_of_time()) return;
    const std::pair<size_t, double> cost{num_held(), squared_ways()};
    Scene other = std::exchange(m_scene, closed);
    let_go_missing(fallen);
    hold_what_does_not_rest();
    if (std::pair(num_held(), squared_ways()) > cost) m_scene = std::move(other);
  }
  std::vector<ObjectId> gone_since(const Scene& before, double metres) const {
    std::vector<ObjectId> out;
    for (const ObjectId id : m_order)
      if (way_between(id, before.at(id).pose, m_scene.at(id).pose) > metres) out.push_back(id);
    return out;
  }
  size_t num_held() const {
    return static_cast<size_t>(
        std::count_if(m_order.begin(), m_order.end(), [&](ObjectId id) { return is_held(id); }));
  }

  // As a whole, or alone.
  void hold_what_does_not_rest() {
    std::vector<ObjectId> let_go;
    for (const ObjectId id : m_order)
      if (!is_held(id)) let_go.push_back(id);
    const std::vector<ObjectId> left = not_at_rest_now(let_go);
    for (const ObjectId id : left)
      if (contains(let_go, id)) hold(id, m_scene.at(id).pose);
  }

  std::vector<ObjectId> not_at_rest_now(const std::vector<ObjectId>& ids) {
    std::vector<ObjectId> left = m_out.rest_together(ids);
    const std::vector<ObjectId> alone = unsettled_objects(m_scene, m_out.options());
    left.insert(left.end(), alone.begin(), alone.end());
    return left;
  }

  void give_up(ObjectId id) {
    release(id);
    take_out(id);
    m_out.give_up(id, Sentence("no place near is free"));
  }

  // All stand still where they are parted: what is let go finds the others there.
  void hold_parted() {
    std::vector<Placement> all;
    all.reserve(m_order.size());
    for (const ObjectId id : m_order) all.push_back({id, m_out.given(id)});
    for (const Placement& p : part_by_turns(m_scene, all, kAirOfParted, m_out.options().is_over))
      hold(p.id, p.pose);
  }

  void hold(ObjectId id, const Pose& pose) {
    edit_object(m_scene, id, [&](Object& o) {
      o.pose = pose;
      o.placed = o.fixed = true;
      o.state = ObjectState::Unsupported;
    });
  }
  bool is_held(ObjectId id) const { return m_scene.at(id).fixed; }
  void release(ObjectId id) {
    edit_object(m_scene, id, [](Object& o) { o.fixed = false; });
  }
  void take_out(ObjectId id) {
    edit_object(m_scene, id, [](Object& o) { o.placed = false; });
  }

  // All others hold, before and after.
  void let_go_alone(ObjectId id) {
    let_go(id, kInfinity);
    hold(id, m_scene.at(id).pose);
  }

  // From where it comes to rest nearest, with all that were let go before it; the others hold.
  // @param farthest  metres: beyond that it is held until others are at rest.
  void let_go(ObjectId id, double farthest) {
    const Pose here = m_scene.at(id).pose;
    release(id);
    take_out(id);
    const Pose free = parted(m_scene, *m_meant.find(id), here);
    std::optional<Rearrangement::Trial> best = best_trial(id, free, farthest);
    // If others would give way under it, these are held, too, and let go after it.
    if (!best && hold_again(id)) best = best_trial(id, free, farthest);
    if (best)
      m_out.redo(*best);
    else
      hold(id, free);
  }

  bool hold_again(ObjectId id) {
    bool any = false;
    for (const ObjectId other : m_order)
      if (other != id && !is_held(other) && m_gives_way.count(other.index)) {
        hold(other, m_scene.at(other).pose);
        any = true;
      }
    return any;
  }

  std::optional<Rearrangement::Trial> best_trial(ObjectId id, const Pose& free, double farthest) {
    std::optional<Rearrangement::Trial> best;
    double least = kInfinity;
    m_gives_way.clear();
    const double others = way_of_others(id);
    std::vector<Pose> tried;
    const std::optional<Pose> rest = rest_as_given(id);
    for (const Pose& start : starts_from(id, rest, free)) {
      if (m_out.is_out_of_time()) break;
      if (falls_as_another(start, tried) || refuse_interpenetration(m_scene, id, start, false))
        continue;
      tried.push_back(start);
      double all = kInfinity;
      const auto judge = [&](const Object& there) {
        const double way = way_to(id, there.pose);
        if (way < farthest) all = way + way_of_others(id) - others;
      };
      Rearrangement::Trial trial = m_out.try_put(id, start, judge, 1);
      if (trial.result.refusal && m_gives_way.empty()) note_who_gives_way(*trial.result.refusal);
      if (all < least) least = all, best = std::move(trial);
      // If contacts hold it as it lies, other starts seldom lead nearer.
      const double near = rest && tried.size() == 1 ? kNearAtRest : kNearInPlace;
      if (least <= near * tolerance()) break;
    }
    return best;
  }

  std::optional<Pose> rest_as_given(ObjectId id) {
    return rest_near_or_beside(m_scene, {id, m_out.given(id)}, tolerance(),
                               clearance_of(m_scene, m_out.options().settle),
                               [this] { return m_out.is_out_of_time(); });
  }
  std::vector<Pose> starts_from(ObjectId id, const std::optional<Pose>& rest,
                                const Pose& free) const {
    std::vector<Pose> out = starts_in_place(m_scene, *m_meant.find(id), free, tolerance());
    if (rest) out.insert(out.begin(), *rest);
    return out;
  }

  void note_who_gives_way(const Refusal& why) {
    for (const Named& name : why.objects)
      if (const auto id = m_scene.find(name.name)) m_gives_way.insert(id->index);
  }

  // The sum over all that were let go.
  double way_of_others(ObjectId id) const {
    double out = 0;
    for (const ObjectId other : m_order)
      if (other != id && !is_held(other)) out += way_to(other, m_scene.at(other).pose);
    return out;
  }

  // From the given pose: the way of its middle and the turn of its half size.
  double way_to(ObjectId id, const Pose& pose) const {
    return way_between(id, m_out.given(id), pose);
  }
  double way_between(ObjectId id, const Pose& from, const Pose& to) const {
    const Object& object = m_scene.at(id);
    const double turn = turn_between_deg(from.rotation, to.rotation) * kRadiansOfDegree;
    return (middle_of_box(object, to) - middle_of_box(object, from)).norm() +
           0.5 * size_of(object) * turn;
  }

  double tolerance() const { return std::max(m_meant.tolerance, 0.002); }

  Scene& m_scene;
  const Intent& m_meant;
  const std::vector<ObjectId>& m_order;
  Rearrangement m_out;
  std::vector<ObjectId> m_missed;        // by the first steps of an attempt
  std::map<std::uint32_t, Pose> m_aims;  // by slot, other than the given poses
  double m_longest_step = 0;             // metres, of an attempt, had it no bound
  std::optional<KnownContacts> m_known;  // of all attempts
  std::set<std::uint32_t> m_gives_way;   // slots, at the first start that was refused
};

}  // namespace

bool is_heap(const Intent& meant, const std::vector<ObjectId>& moving) {
  // A tilted thing on one level object alone has been turned by noise, or leans: it has an order.
  // On the floor two may hold each other, as the boards of a tent.
  std::set<std::uint32_t> in_heap;
  for (const ObjectIntent& o : meant.objects) {
    if (o.is_level) continue;
    const bool on_one_object = o.on.size() == 1 && o.on[0].on.is_object();
    const ObjectIntent* const below = on_one_object ? meant.find(o.on[0].on.object()) : nullptr;
    if (!on_one_object || (below && !below->is_level)) in_heap.insert(o.id.index);
    for (const IntendedSupport& s : o.on) {
      const ObjectIntent* const carrier = s.on.is_object() ? meant.find(s.on.object()) : nullptr;
      if (carrier && !carrier->is_level) in_heap.insert(carrier->id.index);
    }
  }
  const auto tilted = static_cast<size_t>(std::count_if(
      moving.begin(), moving.end(), [&](ObjectId id) { return in_heap.count(id.index) > 0; }));
  return tilted >= kLeastOfHeap &&
         static_cast<double>(tilted) >= kTiltedShareOfHeap * static_cast<double>(moving.size());
}

SettledScene mend_in_place(Scene& scene, const MendOptions& options, const Deadline& deadline,
                           const Intent& meant, const std::vector<ObjectId>& order) {
  return HeapInPlace(scene, options, deadline, meant, order).run();
}

}  // namespace trivet
