#include "ops/operations/commit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "core/base/tunables.h"
#include "ops/operations/leaning.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/rest.h"

namespace trivet {
namespace {

constexpr double kLevelTurn = 1e-12;  // a turn about a vertical axis has no larger x and y

/// Motion of a group from where it was to where it is.
class RigidMove {
 public:
  RigidMove(const Pose& from, const Pose& to) : m_from(from.translation), m_to(to.translation) {
    const Rotation &p = from.rotation, &q = to.rotation;
    m_turned = p.w != q.w || p.x != q.x || p.y != q.y || p.z != q.z;
    if (!m_turned) return;
    const Rotation turn = (q * Rotation{p.w, -p.x, -p.y, -p.z}).normalized();
    m_matrix = turn.matrix();
    m_tilted = std::max(std::abs(turn.x), std::abs(turn.y)) > kLevelTurn;
  }

  bool tilted() const { return m_tilted; }
  Vec3 point(const Vec3& p) const {
    return m_turned ? Vec3(m_to + m_matrix * (p - m_from)) : Vec3(p + (m_to - m_from));
  }
  Contact contact(Contact c) const {
    for (ContactPoint& p : c.points) p.point = point(p.point), p.normal = direction(p.normal);
    for (Vec3& p : c.hull) p = point(p);
    c.normal = direction(c.normal);
    return c;
  }

 private:
  Vec3 direction(const Vec3& d) const { return m_turned ? Vec3(m_matrix * d) : d; }

  Vec3 m_from, m_to;
  Mat3 m_matrix = Mat3::Identity();
  bool m_turned = false, m_tilted = false;
};

/// Ids without duplicates, in the order in which they came.
class IdSet {
 public:
  void add(ObjectId id) {
    if (m_slots.insert(id.index).second) m_ids.push_back(id);
  }
  const std::vector<ObjectId>& ids() const { return m_ids; }

 private:
  std::vector<ObjectId> m_ids;
  std::set<std::uint32_t> m_slots;
};

bool has(const std::vector<ObjectId>& ids, ObjectId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

// True if the centre is inside the hull of the contacts that carry: at rest without further tests.
bool stands_on(const Scene& scene, const Object& object, const std::vector<ContactsWith>& contacts,
               const RestRules& rules) {
  return rate_unheld(scene, object, object.pose, contacts, rules).stability_margin >=
         kRestMargin * size_of(object);
}

// State of an object that is not at rest and was not moved by hand.
ObjectState left_alone(const Scene& scene, ObjectId id, OperationResult& result) {
  const Object& object = scene.at(id);
  if (object.state == ObjectState::Held || object.state == ObjectState::Wedged) return object.state;
  add_name(result.unsupported, object.name);
  return ObjectState::Unsupported;
}

void set_rating(Object& object, ObjectState state, const RestRating& rating) {
  object.state = state;
  object.stability_margin = rating.stability_margin;
  object.least_friction = rating.least_friction;
}

/// An invalid object stays so as long as it interpenetrates something.
/// @param known  its contacts, if they are. @param state  calls its argument to learn whether the
///   object is at rest.
template <class State>
void rate_as(Transaction& transaction, ObjectId id, const RestRules& rules,
             const std::vector<ContactsWith>* known, const State& state) {
  const Scene& scene = transaction.scene();
  const Object& seen = scene.at(id);
  if (seen.fixed || !seen.placed) return;
  const std::vector<Support> crossed = passed_through(scene, id);
  Neighbourhood others(scene, id);
  others.leave_out(crossed);
  const std::vector<ContactsWith> contacts =
      known ? *known : touching(body_of(seen), others, rules.clearance);
  const bool stays = is_invalid(scene, id) && !crossed.empty();
  const ObjectState now = stays ? ObjectState::Invalid : state([&] {
    return stands_on(scene, seen, contacts, rules) || rests_at(seen, seen.pose, others, rules);
  });
  const bool rests = now == ObjectState::Stable || now == ObjectState::Wedged;
  const RestRating rating = rests ? rate_rest(scene, id, seen.pose, contacts, rules)
                                  : rate_unheld(scene, seen, seen.pose, contacts, rules);
  transaction.edit(id, [&](Object& object) { set_rating(object, now, rating); });
}

/// Commit of one plan. Order: contacts and ratings to renew are collected while the scene is as it
/// was, then poses and links change, then ratings.
class GroupCommit {
 public:
  GroupCommit(Transaction& transaction, MovePlan& plan, const SettleOptions& options)
      : m_transaction(transaction),
        m_scene(transaction.scene()),
        m_plan(plan),
        m_group(*plan.group),
        m_rules(rest_rules(options, m_group.clearance())) {}

  void run() {
    const RigidMove move(m_scene.at(m_group.ids()[0]).pose, m_group.pose());
    for (const ObjectId id : m_group.ids()) m_members.insert(id.index);
    for (Index i = 0; i < static_cast<Index>(m_group.ids().size()); ++i) prepare(i, move);
    for (const ObjectId id : m_scene.invalid_objects()) add_partner(id);
    m_to_rate.insert(m_to_rate.end(), m_partners.ids().begin(), m_partners.ids().end());
    for (Index i = 0; i < static_cast<Index>(m_group.ids().size()); ++i) place(i);
    for (const ObjectId id : m_to_rate) rate(id);
    for (const ObjectId id : m_group.ids())
      if (id != m_group.ids()[0]) m_plan.result.carried.push_back(m_scene.at(id).name);
  }

 private:
  bool is_member(ObjectId id) const { return m_members.contains(id.index); }

  // Partners of these contacts are to be rated, too, unless they rest on their own contacts
  // whatever the member does on them or beside them.
  void touch(const std::vector<ObjectContact>& object_contacts) {
    for (const ObjectContact& entry : object_contacts) {
      if (entry.with.is_floor()) continue;
      const ObjectId with = entry.with.object();
      if (!stands_on_its_own(m_scene.at(with)) || weighs_on(entry.contact)) add_partner(with);
    }
  }

  void add_partner(ObjectId id) {
    if (!is_member(id)) m_partners.add(id);
  }

  // The member leaves its neighbours: those that may lean on it are to be rated, too.
  // @return whether it may lean on one of them.
  bool leave(const Object& member) {
    for (const ObjectId id : leaning_on(m_scene, member, m_group.outside())) add_partner(id);
    return leans_on_any(member, m_group.outside());
  }

  bool crosses(ObjectId id) const {
    return std::any_of(m_plan.crossed.begin(), m_plan.crossed.end(),
                       [&](const Interpenetration& x) { return x.id == id; });
  }

  // Contacts that carry: none with what the member interpenetrates.
  std::vector<ContactsWith> contacts_of(Index i) const {
    const ObjectId id = m_group.ids()[i];
    std::vector<ContactsWith> contacts = m_group.contacts(i);
    std::erase_if(contacts, [&](const ContactsWith& c) {
      return std::any_of(m_plan.crossed.begin(), m_plan.crossed.end(),
                         [&](const Interpenetration& x) { return x.id == id && x.with == c.with; });
    });
    return contacts;
  }

  // Links of a member, and whether it has to be rated again.
  void prepare(Index i, const RigidMove& move) {
    const ObjectId id = m_group.ids()[i];
    const Object& object = m_scene.at(id);
    const std::vector<ContactsWith> contacts = contacts_of(i);
    std::vector<ObjectContact> object_contacts =
        object_contacts_of(object, m_group.pose(i), m_scene, contacts, m_group.clearance());
    touch(object_contacts);
    touch(object.contacts);
    const bool leans = leave(object);
    if (m_group.ids().size() == 1) m_contacts = contacts;
    bool rated_again = has(m_group.driven(), id) || move.tilted() || !object_contacts.empty() ||
                       leans || is_invalid(m_scene, id) || crosses(id);
    for (const ObjectContact& entry : object.contacts)
      if (entry.with.is_object() && is_member(entry.with.object()))
        object_contacts.push_back({entry.with, move.contact(entry.contact)});
      else
        rated_again = true;
    if (rated_again) m_to_rate.push_back(id);
    m_object_contacts.push_back(std::move(object_contacts));
  }

  void place(Index i) {
    const ObjectId id = m_group.ids()[i];
    m_transaction.set_contacts(id, std::move(m_object_contacts[i]));
    m_transaction.edit(id, [&](Object& object) {
      object.pose = m_group.pose(i);
      object.placed = true;
      if (object.fixed) object.state = ObjectState::Fixed;
      if (crosses(id)) object.state = ObjectState::Invalid;
      const bool was_in_hand = object.state == ObjectState::Held && has(m_group.driven(), id);
      if (m_plan.settled && was_in_hand) object.state = ObjectState::Stable;  // or what it is rated
    });
  }

  void rate(ObjectId id) {
    const bool is_object = id == m_group.ids()[0];
    const ObjectState otherwise = m_plan.otherwise;
    const auto state = [&](const auto& rests) {
      // A group that settles together may not rest alone.
      if (is_object && m_plan.settled && m_group.ids().size() == 1) return otherwise;
      if (rests()) return ObjectState::Stable;
      const bool by_hand = is_object ? otherwise != ObjectState::Stable
                                     : otherwise == ObjectState::Held && has(m_group.driven(), id);
      return by_hand ? otherwise : left_alone(m_scene, id, m_plan.result);
    };
    rate_as(m_transaction, id, m_rules, is_object && m_contacts ? &*m_contacts : nullptr, state);
  }

  Transaction& m_transaction;
  const Scene& m_scene;
  MovePlan& m_plan;
  const MovingGroup& m_group;
  const RestRules m_rules;
  std::set<std::uint32_t> m_members;  // slots
  std::vector<std::vector<ObjectContact>> m_object_contacts;
  IdSet m_partners;
  std::vector<ObjectId> m_to_rate;
  std::optional<std::vector<ContactsWith>> m_contacts;  // of an object that moves alone
};

}  // namespace

void add_name(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

OperationResult commit(Transaction& transaction, MovePlan plan, OperationRun& run) {
  if (plan.changes_scene) {
    for (const Interpenetration& c : plan.crossed)
      add_name(plan.result.interpenetrates, named(transaction.scene(), c.with).name);
    GroupCommit(transaction, plan, run.options).run();
    if (plan.release && !plan.result.unsupported.empty()) {
      settle_unsupported(transaction, run, plan.group->clearance(), *plan.release, plan.result);
      if (run.interrupt.reason())
        run.interrupt.refuse(plan.op, named(transaction.scene(), Support(plan.group->ids()[0])),
                             plan.result);
    }
  }
  plan.result.milliseconds = run.stopwatch.milliseconds();
  return std::move(plan.result);
}

void commit_object(Transaction& transaction, ObjectId id, const Pose& pose, ObjectState state,
                   const std::vector<ContactsWith>& contacts, const RestRules& rules) {
  const Object& seen = transaction.scene().at(id);
  const bool unheld = state == ObjectState::Held || state == ObjectState::Unsupported ||
                      state == ObjectState::Invalid;
  const RestRating rating = unheld ? rate_unheld(transaction.scene(), seen, pose, contacts, rules)
                                   : rate_rest(transaction.scene(), id, pose, contacts, rules);
  transaction.set_contacts(
      id, object_contacts_of(seen, pose, transaction.scene(), contacts, rules.clearance));
  transaction.edit(id, [&](Object& object) {
    object.pose = pose;
    object.placed = true;
    set_rating(object, state, rating);
  });
}

void rate_left_alone(Transaction& transaction, ObjectId id, const RestRules& rules,
                     OperationResult& result) {
  rate_as(transaction, id, rules, nullptr, [&](const auto& rests) {
    return rests() ? ObjectState::Stable : left_alone(transaction.scene(), id, result);
  });
}

std::vector<ObjectId> dependents_of(const Scene& scene, ObjectId id) {
  const Object& object = scene.at(id);
  IdSet out;
  for (const ObjectContact& entry : object.contacts)
    if (entry.with.is_object()) out.add(entry.with.object());
  for (const ObjectId other : leaning_on(scene, object, Neighbourhood(scene, id))) out.add(other);
  for (const ObjectId other : scene.invalid_objects())
    if (other != id) out.add(other);
  return out.ids();
}

}  // namespace trivet
