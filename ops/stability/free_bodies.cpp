#include "ops/stability/free_bodies.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/friction.h"
#include "core/scene/joint.h"
#include "ops/placement/contacts.h"
#include "ops/placement/slot_order.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/rest.h"
#include "ops/stability/weight.h"

namespace trivet {

namespace {

constexpr size_t kPairContacts = 12;  // points of one pair that the linear program gets
// Least weight, for a model that is one point: the program's numbers are in parts of them.
constexpr double kLeastWeight = 1e-15;  // newtons
// Bodies that moved a little touch at the same place still.
constexpr double kSamePlaceOfContact = 0.005, kSameNormalOfContact = 0.95;  // metres, and a cosine
constexpr double kLeastSize = 1e-9;                                         // metres

// Where ids are in a list of them; ground: nowhere.
class BodyIndex {
 public:
  BodyIndex(const Scene& scene, std::span<const ObjectId> ids) {
    for (size_t i = 0; i < ids.size(); ++i)
      for (const ObjectId id : one_body(scene, ids[i]))
        m_sorted.emplace_back(id.index, static_cast<Index>(i));
    std::sort(m_sorted.begin(), m_sorted.end());
  }

  Index find(const Support& with) const {
    if (with.is_floor()) return BodyContact::kGround;
    const std::uint32_t slot = with.object().index;
    const auto at =
        std::lower_bound(m_sorted.begin(), m_sorted.end(), std::make_pair(slot, Index{0}));
    return at != m_sorted.end() && at->first == slot ? at->second : BodyContact::kGround;
  }

 private:
  std::vector<std::pair<std::uint32_t, Index>> m_sorted;
};

bool contains(const std::vector<ContactPoint>& points, const ContactPoint& p) {
  return std::any_of(points.begin(), points.end(), [&](const ContactPoint& q) {
    return q.point == p.point && q.normal == p.normal;
  });
}

// With the weights of its links.
FreeBody body_with_links(const Scene& scene, ObjectId id) {
  const Object& object = scene.at(id);
  // Weight and size are never zero, as rows are divided by them.
  FreeBody out{id, object.centre_of_mass(), std::max(weight_of(object), kLeastWeight),
               std::max(size_of(object), kLeastSize)};
  if (object.links.empty()) return out;
  Vec3 moment = Vec3::Zero();
  out.weight = 0;
  for (const ObjectId member : one_body(scene, id)) {
    const double weight = std::max(weight_of(scene.at(member)), kLeastWeight);
    moment += weight * scene.at(member).centre_of_mass();
    out.weight += weight;
  }
  out.centre = moment / out.weight;
  return out;
}

FreeBodies bodies_only(const Scene& scene, std::span<const ObjectId> ids) {
  FreeBodies out;
  for (const ObjectId id : ids) out.bodies.push_back(body_with_links(scene, id));
  return out;
}

// Contacts of a member of a body, by the links of the scene.
void add_touches(const Scene& scene, ObjectId member, Index body, const BodyIndex& index,
                 const ContactFriction& friction, FreeBodies& out) {
  for (const ObjectContact& entry : scene.at(member).contacts) {
    // A contact across a gap carries nothing.
    if (entry.across_gap) continue;
    const Index from = index.find(entry.with);
    if (from != BodyContact::kGround && from <= body) continue;  // seen from the other side already
    const double of_pair = friction.of(scene, member, entry.with);
    for (const ContactPoint& p : entry.contact.points)
      out.touches.push_back({body, from, entry.with, of_pair, p});
  }
}

// All members of these bodies.
std::vector<ObjectId> members_up_to(const Scene& scene, std::span<const ObjectId> ids) {
  std::vector<ObjectId> out;
  for (const ObjectId id : ids)
    for (const ObjectId member : one_body(scene, id)) out.push_back(member);
  return out;
}

// A link across a gap still carries where the clearance has become smaller since.
double reach_of(const Object& object, double tolerance) {
  double out = tolerance;
  for (const ObjectContact& entry : object.contacts)
    if (entry.across_gap)
      for (const ContactPoint& p : entry.contact.points) out = std::max(out, p.gap);
  return std::min(out, kMostShrunk * tolerance);
}

}  // namespace

bool are_alike(const BodyContact& a, const BodyContact& b) {
  return a.on == b.on && a.partner == b.partner &&
         (a.contact.point - b.contact.point).norm() < kSamePlaceOfContact &&
         a.contact.normal.dot(b.contact.normal) > kSameNormalOfContact;
}

double ContactFriction::of(const Scene& scene, ObjectId object, const Support& with) const {
  return share * of_all.value_or(friction_between(scene, object, with));
}

bool is_fixed(ObjectId, const Object& object) { return object.fixed; }

bool is_fixed_or_held(ObjectId, const Object& object) {
  return object.fixed || object.state == ObjectState::Held;
}

FreeBodies free_bodies(const Scene& scene, const ContactFriction& friction) {
  std::vector<ObjectId> ids = scene.ids();
  std::erase_if(ids, [&](ObjectId id) { return !scene.at(id).placed || scene.at(id).fixed; });
  return linked_bodies(scene, ids, friction);
}

FreeBodies linked_bodies(const Scene& scene, std::span<const ObjectId> ids,
                         const ContactFriction& friction) {
  FreeBodies out = bodies_only(scene, ids);
  const BodyIndex index(scene, ids);
  for (Index i = 0; i < static_cast<Index>(ids.size()); ++i)
    for (const ObjectId member : one_body(scene, ids[i]))
      add_touches(scene, member, i, index, friction, out);
  return out;
}

namespace {

class NearContacts {
 public:
  NearContacts(const Scene& scene, std::span<const ObjectId> ids, double clearance,
               const IsGround& is_ground, const ContactFriction& friction, double num_clearances,
               FreeBodies& out)
      : m_scene(scene),
        m_ids(ids),
        m_clearance(clearance),
        m_is_ground(is_ground),
        m_friction(friction),
        m_num_clearances(num_clearances),
        m_index(scene, ids),
        m_out(out) {}

  void add_all() {
    for (Index i = 0; i < static_cast<Index>(m_ids.size()); ++i) {
      // Earlier bodies have seen their contacts with this one already.
      const Neighbourhood later(m_scene, members_up_to(m_scene, m_ids.first(i + 1)));
      for (const ObjectId member : one_body(m_scene, m_ids[i])) add(member, i, later);
    }
  }

 private:
  void add(ObjectId member, Index body, const Neighbourhood& later) {
    const double tolerance = reach_of(m_scene.at(member), m_num_clearances * m_clearance);
    for (const ContactsWith& c :
         contacts_with(body_of(m_scene.at(member)), later, tolerance, kFootSlack * m_clearance)) {
      const Index from = m_index.find(c.with);
      // A neighbour that could move is not ground. The caller decides whether it joins these
      // bodies.
      if (from == BodyContact::kGround && could_move(c.with)) continue;
      const double of_pair = m_friction.of(m_scene, member, c.with);
      // The program begins with points that span the contact; the others wait until they are worth
      // it.
      const std::vector<ContactPoint> all = merged(c.points, tolerance);
      const std::vector<ContactPoint> chosen = reduced(all, kPairContacts);
      for (const ContactPoint& p : all)
        (contains(chosen, p) ? m_out.touches : m_out.more)
            .push_back({body, from, c.with, of_pair, p});
    }
  }

  // It is then left out.
  bool could_move(const Support& with) {
    if (with.is_floor()) return false;
    const ObjectId root = root_of(m_scene, with.object());
    if (m_is_ground(root, m_scene.at(root))) return false;
    m_out.left_out.push_back(root);
    return true;
  }

  const Scene& m_scene;
  std::span<const ObjectId> m_ids;
  double m_clearance;
  const IsGround& m_is_ground;
  ContactFriction m_friction;
  double m_num_clearances;
  BodyIndex m_index;
  FreeBodies& m_out;
};

}  // namespace

FreeBodies near_bodies(const Scene& scene, std::span<const ObjectId> ids, double clearance,
                       const IsGround& is_ground, const ContactFriction& friction,
                       double num_clearances) {
  FreeBodies out = bodies_only(scene, ids);
  NearContacts(scene, ids, clearance, is_ground, friction, num_clearances, out).add_all();
  std::sort(out.left_out.begin(), out.left_out.end(), by_slot);
  out.left_out.erase(std::unique(out.left_out.begin(), out.left_out.end()), out.left_out.end());
  return out;
}

std::vector<Index> nearest_bodies(const FreeBodies& all, std::span<const Index> seeds, size_t most,
                                  std::span<const char> may) {
  std::vector<std::vector<Index>> next(all.bodies.size());
  for (const BodyContact& t : all.touches)
    if (t.from != BodyContact::kGround) next[t.on].push_back(t.from), next[t.from].push_back(t.on);
  std::vector<char> seen(all.bodies.size(), 0);
  std::vector<Index> out;
  const auto add = [&](Index i) {
    const bool is_chosen = may.empty() || may[static_cast<size_t>(i)];
    if (is_chosen && out.size() < most && !std::exchange(seen[i], 1)) out.push_back(i);
  };
  for (const Index i : seeds) add(i);
  for (size_t k = 0; k < out.size(); ++k)
    for (const Index i : next[out[k]]) add(i);
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<Index> connected_parts(const FreeBodies& all) {
  std::vector<Index> root(all.bodies.size());
  std::iota(root.begin(), root.end(), 0);
  // Union-find with path halving. The smallest index is the root, so that parts come in the order
  // of the bodies.
  const auto find = [&](Index i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const BodyContact& t : all.touches) {
    if (t.from == BodyContact::kGround) continue;
    const Index a = find(t.on), b = find(t.from);
    root[std::max(a, b)] = std::min(a, b);
  }
  std::vector<Index> part(all.bodies.size());
  Index num_parts = 0;
  for (Index i = 0; i < static_cast<Index>(part.size()); ++i)
    part[i] = find(i) == i ? num_parts++ : part[find(i)];
  return part;
}

}  // namespace trivet
