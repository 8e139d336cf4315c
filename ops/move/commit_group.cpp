#include "ops/move/commit_group.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/base/tunables.h"
#include "ops/move/leaning.h"
#include "ops/settle/equilibrium.h"

namespace trivet {
namespace {

constexpr int kMaxLettingsGo = 8;     // of one object, by settle_unsupported()
constexpr double kLevelTurn = 1e-12;  // a turn about a vertical axis has no larger x and y

/// From where a group was to where it is.
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

bool has(const std::vector<ObjectId>& ids, ObjectId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

void add_name(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

// Whether the centre is inside the hull of the contacts that carry: at rest, without more ado.
bool stands_on(const Object& object, const std::vector<ContactsWith>& contacts, double clearance) {
  return rate_unheld(object, object.pose, contacts, clearance).stability_margin >=
         kRestMargin * object.scale * object.shape->box.diagonal();
}

// The state of an object that is not at rest and was not moved by hand.
ObjectState left_alone(const Scene& scene, ObjectId id, OperationResult& result) {
  const Object& object = scene.at(id);
  if (object.state == ObjectState::Held || object.state == ObjectState::Wedged) return object.state;
  add_name(result.unsupported, object.name);
  return ObjectState::Unsupported;
}

bool is_invalid(const Scene& scene, ObjectId id) {
  return scene.at(id).state == ObjectState::Invalid;
}

/// What is invalid stays so as long as it interpenetrates something.
/// @param known  its contacts, if they are. @param state  asks its argument whether it is at rest.
template <class State>
void rate_as(Scene& scene, ObjectId id, double clearance, const std::vector<ContactsWith>* known,
             const State& state) {
  const Object& seen = std::as_const(scene).at(id);
  if (seen.fixed || !seen.placed) return;
  const std::vector<std::optional<ObjectId>> crossed = passed_through(scene, id);
  Surroundings others(scene, id);
  others.leave_out(crossed);
  const std::vector<ContactsWith> contacts =
      known ? *known : touching(seen, seen.pose, others, clearance);
  const bool stays = is_invalid(scene, id) && !crossed.empty();
  const ObjectState now = stays ? ObjectState::Invalid : state([&] {
    return stands_on(seen, contacts, clearance) || rests_at(seen, seen.pose, others, clearance);
  });
  const bool rests = now == ObjectState::Stable || now == ObjectState::Wedged;
  const RestRating rating = rests ? rate_rest(seen, seen.pose, contacts, clearance)
                                  : rate_unheld(seen, seen.pose, contacts, clearance);
  Object& object = scene.at(id);
  object.state = now;
  object.stability_margin = rating.stability_margin;
  object.least_friction = rating.least_friction;
}

class GroupCommit {
 public:
  GroupCommit(Scene& scene, const MovingGroup& group, OperationResult& result)
      : m_scene(scene), m_group(group), m_result(result) {}

  /// @param crossed  pairs that interpenetrate: their contacts mean nothing.
  void run(ObjectState otherwise, bool settled, const std::vector<Interpenetration>& crossed) {
    const RigidMove move(std::as_const(m_scene).at(m_group.ids()[0]).pose, m_group.pose());
    for (Index i = 0; i < static_cast<Index>(m_group.ids().size()); ++i) prepare(i, move, crossed);
    for (const ObjectId id : invalid_objects(m_scene)) add_partner(id);
    m_to_rate.insert(m_to_rate.end(), m_partners.begin(), m_partners.end());
    for (Index i = 0; i < static_cast<Index>(m_group.ids().size()); ++i) {
      const ObjectId id = m_group.ids()[i];
      Object& object = m_scene.at(id);
      m_scene.link(id, std::move(m_links[i]));
      object.pose = m_group.pose(i);
      object.placed = true;
      if (object.fixed) object.state = ObjectState::Fixed;
      if (crosses(id, crossed)) object.state = ObjectState::Invalid;
      const bool was_in_hand = object.state == ObjectState::Held && has(m_group.led(), id);
      if (settled && was_in_hand) object.state = ObjectState::Stable;  // or what it is rated
    }
    for (const ObjectId id : m_to_rate) rate(id, otherwise, settled);
    for (const ObjectId id : m_group.ids())
      if (id != m_group.ids()[0]) add_name(m_result.carried, std::as_const(m_scene).at(id).name);
  }

 private:
  // What the links are with is to be rated, too, unless it rests on its own contacts whatever the
  // member does on it or beside it.
  void touch(const std::vector<Link>& links) {
    for (const Link& link : links) {
      if (!link.with) continue;
      if (!stands_on_its_own(std::as_const(m_scene).at(*link.with)) || weighs_on(link.contact))
        add_partner(*link.with);
    }
  }

  void add_partner(ObjectId id) {
    if (!has(m_group.ids(), id) && !has(m_partners, id)) m_partners.push_back(id);
  }

  // The member leaves its neighbours: those that may lean on it are to be rated, too.
  // @return whether it may lean on one of them.
  bool leave(const Object& member) {
    for (const ObjectId id : leaning_on(m_scene, member, m_group.outside())) add_partner(id);
    return leans_on_any(m_scene, member, m_group.outside());
  }

  // Links of a member, and whether it has to be rated again.
  void prepare(Index i, const RigidMove& move, const std::vector<Interpenetration>& crossed) {
    const ObjectId id = m_group.ids()[i];
    const Object& object = std::as_const(m_scene).at(id);
    std::vector<ContactsWith> contacts = m_group.contacts(i);
    std::erase_if(contacts, [&](const ContactsWith& c) {
      return std::any_of(crossed.begin(), crossed.end(), [&](const Interpenetration& x) {
        return x.id == id && (x.with ? c.fixed >= 0 && m_group.outside().ids[c.fixed] == *x.with
                                     : c.fixed == ContactsWith::kFloor);
      });
    });
    std::vector<Link> links =
        links_of(object, m_group.pose(i), m_group.outside(), contacts, m_group.clearance());
    touch(links);
    touch(object.links);
    const bool leans = leave(object);
    if (m_group.ids().size() == 1) m_contacts = contacts;
    bool rated_again = has(m_group.led(), id) || move.tilted() || !links.empty() || leans ||
                       is_invalid(m_scene, id) || crosses(id, crossed);
    for (const Link& link : object.links)
      if (link.with && has(m_group.ids(), *link.with))
        links.push_back({link.with, move.contact(link.contact)});
      else
        rated_again = true;
    if (rated_again) m_to_rate.push_back(id);
    m_links.push_back(std::move(links));
  }

  static bool crosses(ObjectId id, const std::vector<Interpenetration>& crossed) {
    return std::any_of(crossed.begin(), crossed.end(),
                       [&](const Interpenetration& x) { return x.id == id; });
  }

  void rate(ObjectId id, ObjectState otherwise, bool settled) {
    const bool is_object = id == m_group.ids()[0];
    const auto state = [&](const auto& rests) {
      // What settles together may not rest alone.
      if (is_object && settled && m_group.ids().size() == 1) return otherwise;
      if (rests()) return ObjectState::Stable;
      const bool by_hand = is_object ? otherwise != ObjectState::Stable
                                     : otherwise == ObjectState::Held && has(m_group.led(), id);
      return by_hand ? otherwise : left_alone(m_scene, id, m_result);
    };
    rate_as(m_scene, id, m_group.clearance(), is_object && m_contacts ? &*m_contacts : nullptr,
            state);
  }

  Scene& m_scene;
  const MovingGroup& m_group;
  OperationResult& m_result;
  std::vector<std::vector<Link>> m_links;
  std::vector<ObjectId> m_partners, m_to_rate;
  std::optional<std::vector<ContactsWith>> m_contacts;  // of an object that moves alone
};

// Lets unsupported objects settle, the lowest first.
class Settling {
 public:
  Settling(Scene& scene, const SettleOptions& options, double clearance,
           const std::optional<std::vector<ObjectId>>& only, Interrupt& interrupt,
           OperationResult& result)
      : m_scene(scene),
        m_options(options),
        m_clearance(clearance),
        m_only(only),
        m_interrupt(interrupt),
        m_result(result) {}

  void run() {
    while (const auto id = lowest()) {
      const std::string name = std::as_const(m_scene).at(*id).name;
      ++m_tries[name];
      m_stuck.insert(name);
      if (let_go(*id)) m_stuck.clear(), add_name(m_result.settled, name);
      if (m_interrupt.reason()) return;
    }
    const auto still_waits = [&](const std::string& name) {
      return std::as_const(m_scene).at(*m_scene.find(name)).state == ObjectState::Unsupported;
    };
    std::erase_if(m_result.unsupported, [&](const std::string& n) { return !still_waits(n); });
    std::erase_if(m_result.settled, still_waits);
  }

 private:
  bool may_be_let_go(const std::string& name) const {
    const auto tries = m_tries.find(name);
    return !m_stuck.contains(name) && (tries == m_tries.end() || tries->second < kMaxLettingsGo);
  }

  std::optional<ObjectId> lowest() const {
    std::optional<ObjectId> best;
    double best_z = kInfinity;
    for (const std::string& name : m_result.unsupported) {
      const std::optional<ObjectId> id = m_scene.find(name);
      if (!id || !may_be_let_go(name) || (m_only && !has(*m_only, *id))) continue;
      const Object& object = std::as_const(m_scene).at(*id);
      if (object.state != ObjectState::Unsupported) continue;
      const double z = Body(*object.shape, object.world_from_object()).world_box.lower.z();
      if (z < best_z) best_z = z, best = id;
    }
    return best;
  }

  /// @return whether anything has changed.
  bool let_go(ObjectId id) {
    MovingGroup group(m_scene, id, {}, m_clearance, m_options);
    if (!why_not_movable(m_scene, group.ids()).empty()) return false;
    const SettleOutcome outcome = group.settle(&m_interrupt);
    if (m_interrupt.reason()) return false;
    const bool rests = outcome.status == SettleOutcome::Status::AtRest;
    if (!rests && !(outcome.status == SettleOutcome::Status::Wedged && m_options.accept_wedged))
      return false;
    OperationResult of_this;
    if (!commit_group(m_scene, group, rests ? ObjectState::Stable : ObjectState::Wedged, true,
                      of_this)
             .empty())
      return false;
    m_result.num_motions += static_cast<int>(outcome.steps.size());
    for (const std::string& left : of_this.unsupported) add_name(m_result.unsupported, left);
    return !outcome.steps.empty() ||
           std::as_const(m_scene).at(id).state != ObjectState::Unsupported;
  }

  Scene& m_scene;
  const SettleOptions& m_options;
  double m_clearance;
  const std::optional<std::vector<ObjectId>>& m_only;
  Interrupt& m_interrupt;
  OperationResult& m_result;
  std::map<std::string, int> m_tries;
  std::set<std::string> m_stuck;  // that cannot settle as long as nothing else does
};

}  // namespace

std::string commit_group(Scene& scene, const MovingGroup& group, ObjectState otherwise,
                         bool settled, OperationResult& result) {
  const std::string why = why_invalid(scene, group.placements(), true);
  if (why.empty()) GroupCommit(scene, group, result).run(otherwise, settled, {});
  return why;
}

void commit_freely(Scene& scene, const MovingGroup& group, OperationResult& result) {
  const std::vector<Interpenetration> crossed =
      interpenetrations(scene, group.placements(), true, std::numeric_limits<size_t>::max());
  for (const Interpenetration& c : crossed)
    add_name(result.interpenetrates, c.with ? std::as_const(scene).at(*c.with).name : "floor");
  GroupCommit(scene, group, result).run(ObjectState::Held, false, crossed);
}

void rate_left_alone(Scene& scene, ObjectId id, double clearance, OperationResult& result) {
  rate_as(scene, id, clearance, nullptr, [&](const auto& rests) {
    return rests() ? ObjectState::Stable : left_alone(scene, id, result);
  });
}

void settle_unsupported(Scene& scene, const SettleOptions& options, double clearance,
                        const std::optional<std::vector<ObjectId>>& only, Interrupt& interrupt,
                        OperationResult& result) {
  Settling(scene, options, clearance, only, interrupt, result).run();
}

}  // namespace trivet
