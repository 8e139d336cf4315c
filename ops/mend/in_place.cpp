#include "ops/mend/in_place.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/io/foreign/scene.h"
#include "ops/check/check.h"
#include "ops/mend/attitudes.h"
#include "ops/mend/close_gaps.h"
#include "ops/mend/part_by_turns.h"
#include "ops/mend/rearrange.h"
#include "ops/mend/rows.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "ops/placement/depth.h"

namespace trivet {
namespace {

constexpr double kAirOfParted = 2e-5;  // metres between an object and what it is parted from
constexpr int kRoundsOfParting = 8;
constexpr double kReachOfClosing = 2;  // tolerances
constexpr double kMostReach = 0.04;    // metres: what is farther falls
// Metres, of closing gaps: the first ones do mostly.
constexpr double kMostSteps[] = {0.006, 0.004, kInfinity};
constexpr double kFarInHeap = 4;  // median ways
// Tolerances within which an object has to come to rest, round by round.
constexpr double kFarthestInPlace[] = {2, 4, 1e9};
constexpr size_t kLeastOfHeap = 2;
constexpr double kTiltedShareOfHeap = 0.2;
// Starts around its place: above and beside it, in tolerances, and turned, in degrees.
constexpr double kLiftsInPlace[] = {0.01, 0.1, 0.3, 1}, kRingsInPlace[] = {0.1, 0.3, 1};
constexpr double kTurnsInPlace[] = {1, 3};
constexpr double kNearInPlace = 0.7;  // tolerances: near enough to look no further
constexpr double kRadiansOfDegree = 3.14159265358979323846 / 180;

Vec3 way_out(const Scene& scene, const ObjectIntent& meant, const ObjectInWorld& mine,
             const Support& with, const Vec3& origin) {
  if (with.is_floor()) return depth_below_floor(mine).metres * Vec3::UnitZ();
  const Object& other = scene.at(with.object());
  const Depth depth = depth_of(mine, in_world(other, other.pose, origin));
  Vec3 way = (depth.metres + kAirOfParted) * depth.way;
  // The way out of what does not carry it is sideways, unless it is steep.
  const bool carries = std::any_of(meant.on.begin(), meant.on.end(),
                                   [&](const IntendedSupport& s) { return s.on == with; });
  if (!carries && std::abs(way.z()) < way.head<2>().norm()) way.z() = 0;
  return way;
}

class HeapInPlace {
 public:
  HeapInPlace(Scene& scene, const MendOptions& options, const Intent& meant,
              const std::vector<ObjectId>& order)
      : m_scene(scene), m_meant(meant), m_order(order), m_out(scene, options, order) {}

  SettledScene run() {
    hold_parted();
    close_all();
    hold_what_does_not_rest();
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
    double way = kInfinity;         // metres, of all
    bool any_is_far = true;
    Scene scene;

    bool is_good() const { return missing.empty() && !any_is_far; }
    bool is_better_than(const Attempt& other) const {
      return std::pair(missing.size(), way) < std::pair(other.missing.size(), other.way);
    }
  };

  // All come into the contacts that hold them. What none within reach would hold is let go alone,
  // and they try again.
  void close_all() {
    const Scene parted = m_scene;
    Attempt best = attempt(kMostSteps[0]);
    std::vector<double> longest{m_longest_step};  // of each attempt
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
    // Letting go goes on while fewer are missing each time.
    std::vector<ObjectId> missing = std::move(best.missing);
    for (size_t before = missing.size() + 1;
         !missing.empty() && missing.size() < before && !m_out.is_out_of_time();) {
      before = missing.size();
      for (const ObjectId id : m_order) hold(id, m_scene.at(id).pose);
      for (const ObjectId id : missing) let_go_alone(id);
      // Back at its given pose what was let go would be missed again.
      missing = close(kMostSteps[0], false);
    }
  }

  // Once more from where the first time ended, if anything is missing.
  Attempt attempt(double most_step) {
    m_longest_step = 0;
    std::vector<ObjectId> missing = close(most_step);
    if (!missing.empty() && !m_out.is_out_of_time()) missing = close(most_step);
    return {std::move(missing), way_of_all(), any_is_far(), m_scene};
  }

  // @return those that nothing holds.
  std::vector<ObjectId> close(double most_step, bool near_given = true) {
    const double clearance = clearance_of(m_scene, m_out.options().settle);
    const double reach = std::min(kReachOfClosing * tolerance(), kMostReach);
    std::vector<Placement> given;
    given.reserve(m_order.size());
    for (const ObjectId id : m_order) given.push_back({id, m_out.given(id)});
    for (const ObjectId id : m_order) release(id);
    const auto is_over = [this] { return m_out.is_out_of_time(); };
    ClosedGaps closed =
        close_gaps(m_scene, given, {clearance, reach, most_step, near_given, is_over});
    m_longest_step = std::max(m_longest_step, closed.longest_step);
    return std::move(closed.not_held);
  }

  std::vector<double> ways() const {
    std::vector<double> out;
    out.reserve(m_order.size());
    for (const ObjectId id : m_order) out.push_back(way_to(id, m_scene.at(id).pose));
    return out;
  }
  double way_of_all() const {
    double out = 0;
    for (const double way : ways()) out += way;
    return out;
  }
  // A wrong contact has dragged it along.
  bool any_is_far() const {
    std::vector<double> sorted = ways();
    std::sort(sorted.begin(), sorted.end());
    return sorted.back() > kFarInHeap * sorted[sorted.size() / 2];
  }

  // As a whole, or alone.
  void hold_what_does_not_rest() {
    std::vector<ObjectId> let_go;
    for (const ObjectId id : m_order)
      if (!is_held(id)) let_go.push_back(id);
    std::vector<ObjectId> left = m_out.rest_together(let_go);
    const std::vector<ObjectId> alone = unsettled_objects(m_scene, m_out.options());
    left.insert(left.end(), alone.begin(), alone.end());
    for (const ObjectId id : left)
      if (contains(let_go, id)) hold(id, m_scene.at(id).pose);
  }

  void give_up(ObjectId id) {
    release(id);
    take_out(id);
    m_out.give_up(id, m_out.is_out_of_time() ? Sentence("the time is over")
                                             : Sentence("no place near is free"));
  }

  // All stand still where they are parted: what is let go finds the others there.
  void hold_parted() {
    std::vector<Placement> all;
    all.reserve(m_order.size());
    for (const ObjectId id : m_order) all.push_back({id, m_out.given(id)});
    for (const Placement& p : part_by_turns(m_scene, all, kAirOfParted)) hold(p.id, p.pose);
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
    std::optional<Pose> start = best_start(id, free, farthest);
    // If others would give way under it, these are held, too, and let go after it.
    if (!start && hold_again(id)) start = best_start(id, free, farthest);
    if (!start || !m_out.put(id, *start, 1).ok()) hold(id, free);
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

  std::optional<Pose> best_start(ObjectId id, const Pose& free, double farthest) {
    std::optional<Pose> best;
    double least = kInfinity;
    m_gives_way.clear();
    const double others = way_of_others(id);
    for (const Pose& start : starts_of(id, free)) {
      if (m_out.is_out_of_time()) break;
      if (refuse_interpenetration(m_scene, id, start, false)) continue;
      const auto judge = [&](const Object& there) {
        const double way = way_to(id, there.pose), all = way + way_of_others(id) - others;
        if (way < farthest && all < least) least = all, best = start;
      };
      const OperationResult result = m_out.try_put(id, start, judge, 1);
      if (result.refusal && m_gives_way.empty()) note_who_gives_way(*result.refusal);
      if (least <= kNearInPlace * tolerance()) break;
    }
    return best;
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
    const Pose& given = m_out.given(id);
    const Object& object = m_scene.at(id);
    const double turn = turn_between_deg(given.rotation, pose.rotation) * kRadiansOfDegree;
    return (middle_of_box(object, pose) - middle_of_box(object, given)).norm() +
           0.5 * size_of(object) * turn;
  }

  double tolerance() const { return std::max(m_meant.tolerance, 0.002); }

  // Above the free pose, then beside it, then turned about level axes.
  std::vector<Pose> starts_of(ObjectId id, const Pose& free) const {
    std::vector<Pose> out{free};
    const ObjectIntent& meant = *m_meant.find(id);
    if (meant.is_level) out.push_back(parted(m_scene, meant, levelled_from(id, free)));
    for (const double lift : kLiftsInPlace) out.push_back(moved(free, lift * Vec3::UnitZ()));
    for (const double ring : kRingsInPlace)
      for (int k = 0; k < 8; ++k) {
        const Vec3 way = turn_about(Vec3::UnitZ(), 45.0 * k).matrix().col(0);
        out.push_back(moved(free, ring * way + 0.1 * Vec3::UnitZ()));
      }
    const Vec3 middle = middle_of_box(m_scene.at(id), free);
    for (const double degrees : kTurnsInPlace)
      for (int k = 0; k < 8; ++k) {
        const Vec3 axis = turn_about(Vec3::UnitZ(), 45.0 * k).matrix().col(0);
        const Rotation turn = turn_about(axis, degrees).normalized();
        const Pose turned{(turn * free.rotation).normalized(),
                          middle + turn.matrix() * (free.translation - middle)};
        out.push_back(moved(turned, 0.3 * Vec3::UnitZ()));
      }
    return out;
  }
  // Its level attitude, about the middle of where it is.
  Pose levelled_from(ObjectId id, const Pose& free) const {
    const Object& object = m_scene.at(id);
    Pose out = m_meant.find(id)->level;
    out.translation += middle_of_box(object, free) - middle_of_box(object, out);
    return out;
  }
  Pose moved(Pose pose, const Vec3& tolerances) const {
    pose.translation += tolerance() * tolerances;
    return pose;
  }

  Scene& m_scene;
  const Intent& m_meant;
  const std::vector<ObjectId>& m_order;
  Rearrangement m_out;
  double m_longest_step = 0;            // metres, of an attempt, had it no bound
  std::set<std::uint32_t> m_gives_way;  // slots, at the first start that was refused
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

Pose parted(const Scene& scene, const ObjectIntent& meant, Pose pose) {
  pose.translation.z() += kAirOfParted;
  // Each round parts it from all that it crosses; it may then cross others.
  for (int round = 0; round < kRoundsOfParting; ++round) {
    const Placement here{meant.id, pose};
    const auto found = interpenetrations(scene, {&here, 1}, false, 8);
    if (found.empty()) break;
    const Vec3 origin = origin_with(scene, {&here, 1});
    const ObjectInWorld mine = in_world(scene.at(meant.id), pose, origin);
    for (const Interpenetration& x : found)
      pose.translation += way_out(scene, meant, mine, x.with, origin);
  }
  return pose;
}

SettledScene mend_in_place(Scene& scene, const MendOptions& options, const Intent& meant,
                           const std::vector<ObjectId>& order) {
  return HeapInPlace(scene, options, meant, order).run();
}

}  // namespace trivet
