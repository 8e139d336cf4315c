#include "ops/operations/whole.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>

#include "core/base/tunables.h"
#include "core/contact/contact_memory.h"
#include "ops/operations/commit.h"
#include "ops/operations/joint_motion.h"
#include "ops/placement/slot_order.h"
#include "ops/settle/program_memory.h"
#include "ops/stability/part.h"
#include "ops/stability/weight.h"

namespace trivet {
namespace {

constexpr int kMaxRounds = 24;         // joint motions and judgements
constexpr int kMaxMotionsOfAll = 120;  // of single objects with their loads, in one round
constexpr int kMaxMotionsOfOne = 30;   // of these, of one object
constexpr double kMuch = 0.2;          // of what all have sunk by so far, in one round
constexpr double kCreep = 1e-3;        // of the sizes of those that move: less ends nowhere
constexpr double kLongestTurn = 0.1;   // of an object with loads, tan(angle / 2): loads slide then
constexpr int kMaxProgramObjects = 200;

class Whole {
 public:
  Whole(Transaction& transaction, const Named& object, double clearance, OperationRun& run,
        OperationResult& result, Budget budget, Purpose purpose)
      : m_transaction(transaction),
        m_scene(transaction.scene()),
        m_object(object),
        m_clearance(clearance),
        m_run(run),
        m_result(result),
        m_rules(rest_rules(run.options, clearance)),
        m_queries_left(budget.first_contacts),
        m_most_movers(budget.most_movers),
        m_while_sinking(budget.while_sinking),
        m_is_trial(purpose == Purpose::Trial) {}

  /// @param ids  what a hand has moved and still holds where it does not rest.
  void keep_in_hand(std::vector<ObjectId> ids) { m_in_hand = std::move(ids); }

  Budget budget_left() const { return {m_queries_left, m_most_movers, m_while_sinking}; }

  void settle() {
    for (const ObjectId id : m_scene.invalid_objects())
      if (m_scene.at(id).placed) return;  // no other verdict counts until that is resolved
    // The parts that the operation has touched are judged, and those that topple give way, until
    // all stand.
    PartVerdict verdict = judge();
    // A hand holds what it has moved: it does not topple.
    if (!verdict.stands && hold(verdict.topples)) verdict = judge();
    for (int round = 0; !verdict.stands && round < kMaxRounds && may_go_on(verdict); ++round) {
      const double before = energy_gained().sum;
      const std::int64_t left = m_queries_left;
      if (stopped() || !give_way(verdict)) break;
      const Energy now = energy_gained();
      assert(now.sum <= before + now.rounding);
      const double sunk = before - now.sum;
      if (sunk > -kMuch * now.sum && sunk > kCreep * weighted_sizes(verdict.topples))
        give_back(left - m_queries_left);
      verdict = judge();
    }
    if (stopped()) return;
    // Parts that do not come to rest in time are refused as a whole.
    if (!verdict.stands) return refuse(verdict);
    if (!m_is_trial) note_who_gave_way();
  }

 private:
  bool may_go_on(const PartVerdict& verdict) const {
    return m_queries_left > 0 && verdict.topples.size() <= m_most_movers;
  }

  bool stopped() const { return m_run.interrupt.reason().has_value(); }

  // The hand does not let go of what would rest alone, pinched by others, but not with them.
  bool hold(const std::vector<ObjectId>& topples) {
    bool any = false;
    for (const ObjectId id : m_in_hand) {
      if (std::find(topples.begin(), topples.end(), id) == topples.end()) continue;
      m_transaction.edit(id, [](Object& object) { object.state = ObjectState::Held; });
      any = true;
    }
    return any;
  }

  // All together; and if they stand, each by its own contacts: the part counts what is some
  // clearances away as a contact, which may be all that holds an object.
  PartVerdict judge() {
    // Only parts connected with what changed can have lost their balance.
    const std::vector<ObjectId> changed = touched();
    // It does not matter who would move where none may.
    PartVerdict verdict = judge_parts(m_scene, connected_with(m_scene, changed), changed,
                                      m_clearance, kMaxProgramObjects, friction(),
                                      m_most_movers == 0 ? Toppling::SomeWillDo : Toppling::All);
    if (!verdict.stands || m_is_trial) return verdict;
    judge_each();
    // Names are sorted, so that the order in which they were found does not matter.
    std::vector<std::string> names = m_result.unsupported;
    std::sort(names.begin(), names.end());
    for (const std::string& name : names)
      if (const auto id = m_scene.find(name); id && may_move(*id)) verdict.topples.push_back(*id);
    verdict.stands = verdict.topples.empty();
    return verdict;
  }

  ContactFriction friction() const { return {std::nullopt, friction_share(m_run.options)}; }

  std::vector<ObjectId> parts() const { return connected_with(m_scene, touched()); }

  std::vector<ObjectId> touched() const {
    std::vector<ObjectId> out = m_transaction.touched();
    std::erase_if(out, [&](ObjectId id) { return !m_scene.contains(id); });
    return out;
  }

  struct Energy {
    double sum = 0, rounding = 0;
  };

  // Weights times rises of all that gave way so far. Never grows, whoever gives way.
  Energy energy_gained() const {
    Energy out;
    // Rounding of heights is allowed for in the sum.
    for (const auto& [slot, before] : m_before) {
      const double weight = weight_of(m_scene.at(before.id)), now = height(before.id);
      out.sum += weight * (now - centre_before(before).z());
      out.rounding += 1e-12 * weight * std::abs(now);
    }
    return out;
  }

  // Newtons times metres.
  double weighted_sizes(const std::vector<ObjectId>& ids) const {
    double out = 0;
    for (const ObjectId id : ids) out += weight_of(m_scene.at(id)) * size_of(m_scene.at(id));
    return out;
  }

  Vec3 centre_before(const Placement& before) const {
    const Object& object = m_scene.at(before.id);
    return body_of(object, before.pose).world_from_object.apply(object.shape->mass.centre);
  }

  bool give_way(const PartVerdict& verdict) {
    // Single objects move first; a joint motion is searched for when each holds alone.
    if (move_each(m_transaction, verdict.topples)) return true;
    // The motion will meet what is near, but too far to carry.
    const FreeBodies part =
        near_part(m_scene, parts(), m_clearance, is_fixed_or_held, friction(), kBalanceTolerance);
    // Members of groups and locked objects take no part in joint motions.
    std::vector<ObjectId> free = verdict.topples;
    std::erase_if(free, [&](ObjectId id) { return !may_move_alone(id); });
    note_poses(free);
    const JointMotionResult result =
        move_jointly(m_transaction, part, free, m_clearance, m_run, m_queries_left,
                     [this](Transaction& inner, const std::vector<ObjectId>& moved) {
                       move_each(inner, moved);
                     });
    count(result.num_queries);
    return result.moved;
  }

  // Each with its loads, the lowest first, until each holds alone.
  bool move_each(Transaction& transaction, const std::vector<ObjectId>& ids) {
    std::vector<ObjectId> waiting = ids;
    std::map<std::uint32_t, int> num_tries;
    bool moved = false;
    // Objects that touch a moved one may have lost their support, and wait again.
    for (int n = 0; !waiting.empty() && n < kMaxMotionsOfAll && !stopped(); ++n) {
      if (m_queries_left <= 0) break;
      const auto lowest =
          std::min_element(waiting.begin(), waiting.end(),
                           [&](ObjectId a, ObjectId b) { return height(a) < height(b); });
      const ObjectId id = *lowest;
      waiting.erase(lowest);
      if (++num_tries[id.index] > kMaxMotionsOfOne) continue;
      const std::vector<ObjectId> touched = partners(id);
      if (!move_one(transaction, id)) continue;
      moved = true;
      for (const auto& more : {std::vector{id}, touched, partners(id)})
        for (const ObjectId other : more)
          if (std::find(waiting.begin(), waiting.end(), other) == waiting.end())
            waiting.push_back(other);
    }
    return moved;
  }

  void count(std::int64_t queries) { m_queries_left -= queries; }

  void give_back(std::int64_t queries) {
    const std::int64_t back = std::min(queries, m_while_sinking);
    m_queries_left += back;
    m_while_sinking -= back;
  }

  double height(ObjectId id) const { return m_scene.at(id).centre_of_mass().z(); }

  bool may_move(ObjectId id) const {
    const Object& object = m_scene.at(id);
    return object.placed && !object.fixed && object.state != ObjectState::Held &&
           object.state != ObjectState::Invalid;
  }

  // In a joint motion bodies of a group would part, and links from what they hang in.
  bool may_move_alone(ObjectId id) const {
    const Object& object = m_scene.at(id);
    return may_move(id) && !object.locked && object.links.empty() &&
           m_scene.group_members(object.group).size() <= 1;
  }

  std::vector<ObjectId> partners(ObjectId id) const {
    std::vector<ObjectId> out;
    for (const ObjectContact& entry : m_scene.at(id).contacts)
      if (entry.with.is_object() && may_move(entry.with.object()))
        out.push_back(entry.with.object());
    return out;
  }

  bool move_one(Transaction& transaction, ObjectId id) {
    MovingGroup group(m_scene, id, {}, m_clearance, m_run.options, m_run.detector);
    // The object moves only if everything it carries may.
    if (!std::all_of(group.ids().begin(), group.ids().end(),
                     [&](ObjectId member) { return may_move(member); }) ||
        refuse_immovable(m_scene, group.ids()))
      return false;
    note_poses(group.ids());
    const SettleOutcome outcome = group.give_way(&m_run.interrupt, kLongestTurn, m_queries_left);
    count(group.num_queries());
    // A motion counts if it lowers the object and passes the exact test.
    double drop = 0;
    for (const SettleStep& step : outcome.steps) drop += step.energy_drop;
    const bool lies = outcome.status == SettleOutcome::Status::AtRest ||
                      outcome.status == SettleOutcome::Status::TooManyMotions ||
                      outcome.status == SettleOutcome::Status::Wedged;
    if (!lies || stopped() || drop < kEnergyDrop * m_clearance ||
        refuse_interpenetration(m_scene, group.placements(), true))
      return false;
    place(transaction, group);
    m_result.num_motions += static_cast<int>(outcome.steps.size());
    return true;
  }

  // Poses and links alone: whether each is at rest is asked once, at the end.
  void place(Transaction& transaction, const MovingGroup& group) const {
    for (const Placement& p : group.placements())
      transaction.edit(p.id, [&](Object& object) { object.pose = p.pose; });
    for (const Placement& p : group.placements()) {
      const Object& object = m_scene.at(p.id);
      commit_object(transaction, p.id, p.pose, object.state,
                    touching(body_of(object), Neighbourhood(m_scene, p.id), m_clearance), m_rules);
    }
  }

  void note_poses(std::span<const ObjectId> ids) {
    for (const ObjectId id : ids) m_before.emplace(id.index, Placement{id, m_scene.at(id).pose});
  }

  void note_who_gave_way() {
    std::vector<ObjectId> ids;
    // Objects are named in the order of the scene, whoever gave way first.
    ids.reserve(m_before.size());
    for (const auto& [slot, before] : m_before) ids.push_back(before.id);
    m_scene.sort(ids);
    for (const ObjectId id : ids) {
      const Placement& before = m_before.at(id.index);
      const Object& object = m_scene.at(id);
      // The turn is told by the angle between both orientations.
      const Rotation &p = before.pose.rotation, &q = object.pose.rotation;
      const double moved = (object.centre_of_mass() - centre_before(before)).norm();
      const Rotation turn = (q * Rotation{p.w, -p.x, -p.y, -p.z}).normalized();
      const double turned = angle_deg(turn);
      if (object.name != m_object.name && (moved > 0 || turned > 0))
        m_result.gave_way.push_back({object.name, moved, turned});
    }
  }

  // Rest of each that was touched, or leant on what gave way.
  void judge_each() {
    std::vector<ObjectId> ids;
    if (!m_before.empty()) ids = touched();
    // Objects that leant on the former place may have lost it.
    for (const auto& [slot, before] : m_before) {
      const Body was = body_of(m_scene.at(before.id), before.pose);
      const std::vector<ObjectId> leaning = m_scene.leaning_near(was.world_box);
      ids.insert(ids.end(), leaning.begin(), leaning.end());
    }
    std::sort(ids.begin(), ids.end(), by_slot);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    for (const ObjectId id : ids)
      if (may_move(id)) rate_left_alone(m_transaction, id, m_rules, m_result);
    std::erase_if(m_result.unsupported, [&](const std::string& name) {
      const auto id = m_scene.find(name);
      return id && m_scene.at(*id).state != ObjectState::Unsupported;
    });
  }

  static double angle_deg(const Rotation& r) {
    const double sine = std::sqrt(r.x * r.x + r.y * r.y + r.z * r.z), cosine = std::abs(r.w);
    return sine <= cosine ? turned_deg(sine / cosine) : 180 - turned_deg(cosine / sine);
  }

  void refuse(const PartVerdict& verdict) {
    // The refusal names all that topple, and the least friction among their contacts.
    Refusal why{Refusal::Cause::Topples, {m_object}};
    const ContactFriction rule = friction();
    double least = kInfinity;
    for (const ObjectId id : verdict.topples) {
      why.objects.push_back(named(m_scene, Support(id)));
      least = std::min(least, rule.share * m_scene.at(id).material.friction);
      for (const ObjectContact& entry : m_scene.at(id).contacts)
        least = std::min(least, rule.of(m_scene, id, entry.with));
    }
    why.numbers = {{"friction", least}};
    m_result.refuse(std::move(why));
  }

  Transaction& m_transaction;
  const Scene& m_scene;
  const Named& m_object;
  const double m_clearance;
  OperationRun& m_run;
  OperationResult& m_result;
  const RestRules m_rules;
  const ContactMemory m_memory;  // what stays where it is, is judged again and again
  const ProgramMemory m_programs;
  std::int64_t m_queries_left;
  const size_t m_most_movers;
  std::int64_t m_while_sinking;
  const bool m_is_trial;
  std::vector<ObjectId> m_in_hand;
  std::map<std::uint32_t, Placement> m_before;  // by slot
};

}  // namespace

Budget settle_whole(Transaction& transaction, const Named& object, double clearance,
                    OperationRun& run, OperationResult& result, Budget budget, Purpose purpose,
                    std::vector<ObjectId> in_hand) {
  Whole whole(transaction, object, clearance, run, result, budget, purpose);
  whole.keep_in_hand(std::move(in_hand));
  whole.settle();
  return whole.budget_left();
}

}  // namespace trivet
