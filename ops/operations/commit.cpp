#include "ops/operations/commit.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/friction.h"
#include "ops/operations/carriers.h"
#include "ops/operations/leaning.h"
#include "ops/settle/rest.h"

namespace trivet {
namespace {

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

double margin_by_links(const Scene& scene, ObjectId id, const RestRules& rules) {
  const Object& object = scene.at(id);
  return rate_unheld(scene, object, object.pose, linked_contacts(object), rules).stability_margin;
}

// State of an object that is not at rest and was not moved by hand.
ObjectState left_alone(const Scene& scene, ObjectId id, OperationResult& result) {
  const Object& object = scene.at(id);
  if (object.state == ObjectState::Held || object.state == ObjectState::Wedged) return object.state;
  add_name(result.unsupported, object.name);
  return ObjectState::Unsupported;
}

/// State and margin by the links. An invalid object stays so as long as it interpenetrates
/// something; one whose centre is inside the hull of the contacts that carry is at rest without
/// further tests.
/// @param state  calls its argument to learn whether the object is at rest.
template <class State>
void rate_as(Transaction& transaction, ObjectId id, const RestRules& rules, const State& state) {
  const Scene& scene = transaction.scene();
  const Object& seen = scene.at(id);
  if (seen.fixed || !seen.placed) return;
  const std::vector<Support> crossed = passed_through(scene, id);
  // Margin and state follow from links alone, so that a scene that is read again is rated alike.
  const double margin = margin_by_links(scene, id, rules);
  // An invalid object gets no other state while it still crosses something.
  const bool stays = is_invalid(scene, id) && !crossed.empty();
  const ObjectState now = stays ? ObjectState::Invalid : state([&] {
    if (margin >= kRestMargin * size_of(seen)) return true;
    Neighbourhood others(scene, id);
    others.leave_out(crossed);
    return rests_at(seen, seen.pose, others, rules);
  });
  transaction.edit(id, [&](Object& object) {
    object.state = now;
    object.stability_margin = margin;
  });
}

/// Commit of one plan. Order: what is to be rated again is collected while the scene is as it was,
/// then poses change, then links, then ratings.
class GroupCommit {
 public:
  GroupCommit(Transaction& transaction, MovePlan& plan, const SettleOptions& options)
      : m_transaction(transaction),
        m_scene(transaction.scene()),
        m_plan(plan),
        m_group(*plan.group),
        m_rules(rest_rules(options, m_group.clearance())) {}

  void run() {
    const Index num_members = static_cast<Index>(m_group.ids().size());
    // Partners are collected while the old contacts are still there.
    for (const ObjectId id : m_group.ids()) m_members.insert(id.index);
    for (Index i = 0; i < num_members; ++i) prepare(i);
    for (const ObjectId id : m_scene.invalid_objects()) add_partner(id);
    find_inner_contacts();
    // All poses change before any contact is set, as contacts are found between the new places.
    for (Index i = 0; i < num_members; ++i) place(i);
    for (Index i = 0; i < num_members; ++i) link(i);
    // Members are rated first, then those that they left or met.
    for (const ObjectId id : m_group.ids()) rate(id);
    for (const ObjectId id : m_partners.ids()) rate(id);
    for (const ObjectId id : m_group.ids())
      if (id != m_group.ids()[0]) m_plan.result.carried.push_back(m_scene.at(id).name);
  }

 private:
  bool is_member(ObjectId id) const { return m_members.contains(id.index); }

  // Partners of these contacts are to be rated, too, unless they rest on their own contacts
  // whatever the member does on them or beside them.
  void touch(const ObjectContact& entry) {
    if (entry.with.is_floor()) return;
    const ObjectId with = entry.with.object();
    if (!stands_on_its_own(m_scene.at(with)) || weighs_on(entry)) add_partner(with);
  }

  void add_partner(ObjectId id) {
    if (!is_member(id)) m_partners.add(id);
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

  // Contacts of a member with the outside, and whom it leaves or meets.
  void prepare(Index i) {
    const Object& object = m_scene.at(m_group.ids()[i]);
    m_contacts.push_back(contacts_of(i));
    for (const ObjectContact& entry : object_contacts_of(object, m_group.pose(i), m_scene,
                                                         m_contacts.back(), m_group.clearance()))
      touch(entry);
    for (const ObjectContact& entry : object.contacts) touch(entry);
    for (const ObjectId id : leaning_on(m_scene, object, m_group.outside())) add_partner(id);
  }

  // They move as one, but turned and rounded: contacts follow from the poses alone.
  void find_inner_contacts() {
    const std::span<const Body> bodies = m_group.bodies();
    for (size_t i = 0; i < bodies.size(); ++i)
      for (size_t j = i + 1; j < bodies.size(); ++j) {
        if (may_pass(m_scene, m_scene.at(m_group.ids()[i]), m_scene.at(m_group.ids()[j]))) continue;
        std::vector<ContactPoint> points =
            contact_points(bodies[i], bodies[j], kContactTolerance * m_group.clearance(),
                           kFootSlack * m_group.clearance());
        if (points.empty()) continue;
        m_contacts[i].push_back({m_group.ids()[j], points});
        for (ContactPoint& p : points) p = seen_from_support(p);
        m_contacts[j].push_back({m_group.ids()[i], std::move(points)});
      }
  }

  void place(Index i) {
    const ObjectId id = m_group.ids()[i];
    m_transaction.edit(id, [&](Object& object) {
      object.pose = m_group.pose(i);
      object.placed = true;
      if (object.fixed) object.state = ObjectState::Fixed;
      if (crosses(id)) object.state = ObjectState::Invalid;
      const bool was_in_hand = object.state == ObjectState::Held && has(m_group.driven(), id);
      if (m_plan.settled && was_in_hand) object.state = ObjectState::Stable;  // or what it is rated
    });
  }

  void link(Index i) {
    const ObjectId id = m_group.ids()[i];
    // Bodies that cross each other have contacts that mean nothing.
    const std::vector<Support> crossed = passed_through(m_scene, id);
    std::erase_if(m_contacts[i], [&](const ContactsWith& c) {
      return std::find(crossed.begin(), crossed.end(), c.with) != crossed.end();
    });
    m_transaction.set_contacts(id, object_contacts_of(m_scene.at(id), m_group.pose(i), m_scene,
                                                      m_contacts[i], m_group.clearance()));
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
    rate_as(m_transaction, id, m_rules, state);
  }

  Transaction& m_transaction;
  const Scene& m_scene;
  MovePlan& m_plan;
  const MovingGroup& m_group;
  const RestRules m_rules;
  std::set<std::uint32_t> m_members;                  // slots
  std::vector<std::vector<ContactsWith>> m_contacts;  // of each member
  IdSet m_partners;
};

}  // namespace

void add_name(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

OperationResult commit(Transaction& transaction, MovePlan plan, OperationRun& run) {
  if (plan.changes_scene) {
    // The objects that a free move has pushed into are named, not moved.
    for (const Interpenetration& c : plan.crossed)
      add_name(plan.result.interpenetrates, named(transaction.scene(), c.with).name);
    GroupCommit(transaction, plan, run.options).run();
    // Objects that lost their support are released only if the operation asks for it.
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
  const Scene& scene = transaction.scene();
  transaction.set_contacts(
      id, object_contacts_of(scene.at(id), pose, scene, contacts, rules.clearance));
  transaction.edit(id, [&](Object& object) {
    object.pose = pose;
    object.placed = true;
    object.state = state;
  });
  const double margin = margin_by_links(scene, id, rules);
  transaction.edit(id, [&](Object& object) { object.stability_margin = margin; });
}

void rate_again(Transaction& transaction, std::vector<ObjectId> ids, const RestRules& rules) {
  const Scene& scene = transaction.scene();
  // An object may have been deleted or taken out meanwhile.
  std::erase_if(ids, [&](ObjectId id) { return !scene.contains(id) || !scene.at(id).placed; });
  for (const ObjectId id : ids) {
    const RestRating rating = rating_by_links(scene, id, rules);
    transaction.edit(id, [&](Object& object) {
      object.stability_margin = rating.stability_margin;
      object.least_friction = rating.least_friction;
    });
  }
  // Carriers are looked for when all margins are known.
  for (const ObjectId id : ids) link_carriers(transaction, id, rules);
}

void rate_left_alone(Transaction& transaction, ObjectId id, const RestRules& rules,
                     OperationResult& result) {
  const RestRules known = rules_by_links(transaction.scene().at(id), rules);
  rate_as(transaction, id, known, [&](const auto& rests) {
    return rests() ? ObjectState::Stable : left_alone(transaction.scene(), id, result);
  });
}

std::vector<ObjectId> dependents_of(const Scene& scene, ObjectId id) {
  const Object& object = scene.at(id);
  IdSet out;
  // Partners, objects across a gap, and invalid ones may all change when the object goes.
  for (const ObjectContact& entry : object.contacts)
    if (entry.with.is_object()) out.add(entry.with.object());
  for (const ObjectId other : leaning_on(scene, object, Neighbourhood(scene, id))) out.add(other);
  for (const ObjectId other : scene.invalid_objects())
    if (other != id) out.add(other);
  return out.ids();
}

}  // namespace trivet
