#include "ops/stability/part.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <set>
#include <utility>

#include "core/scene/joint.h"
#include "ops/placement/slot_order.h"
#include "ops/stability/certificate.h"
#include "ops/stability/contact_forces.h"
#include "ops/stability/fewest_movers.h"
#include "ops/stability/interior_point.h"
#include "ops/stability/unbalanced.h"

namespace trivet {
namespace {

// False if a body has no contact that could push it up, but by what is tolerated.
bool may_all_be_held_up(const FreeBodies& part) {
  // A body that is pushed up by certified ones has a support already.
  std::vector<char> held;
  for (const FreeBody& body : part.bodies) held.push_back(body.load.z() > 0);
  // Friction may lift even where the normal leans down a little.
  const auto note = [&](Index body, double normal_z, double friction) {
    if (body != BodyContact::kGround && normal_z > -friction) held[body] = 1;
  };
  for (const auto* touches : {&part.touches, &part.more})
    for (const BodyContact& t : *touches) {
      note(t.on, t.contact.normal.z(), t.friction);
      note(t.from, -t.contact.normal.z(), t.friction);
    }
  return std::all_of(held.begin(), held.end(), [](char is_held) { return is_held; });
}

class Judgement {
 public:
  Judgement(const Scene& scene, std::span<const ObjectId> ids, std::span<const ObjectId> changed,
            double clearance, int max_program_objects, const ContactFriction& friction,
            Toppling toppling)
      : m_scene(scene),
        m_ids(ids),
        m_changed(changed),
        m_clearance(clearance),
        m_limit(static_cast<size_t>(max_program_objects)),
        m_friction(friction),
        m_toppling(toppling),
        m_all(linked_bodies(scene, ids, friction)),
        m_certificate(vertical_certificate(m_all)) {}

  PartVerdict run() {
    // Contacts join bodies to parts; only parts with an open body need the program.
    const std::vector<Index> part_of = connected_parts(m_all);
    std::vector<Members> parts(
        part_of.empty() ? 0 : 1 + *std::max_element(part_of.begin(), part_of.end()));
    for (size_t i = 0; i < part_of.size(); ++i) {
      Members& part = parts[part_of[i]];
      part.all.push_back(static_cast<Index>(i));
      if (!m_certificate.bodies[i].certified) part.open.push_back(static_cast<Index>(i));
    }
    for (const Members& part : parts)
      if (!part.open.empty()) judge(part);
    std::vector<ObjectId>& topples = m_out.topples;  // of parts that near contacts join, twice
    std::sort(topples.begin(), topples.end(), by_name(m_scene));
    topples.erase(std::unique(topples.begin(), topples.end()), topples.end());
    return std::move(m_out);
  }

 private:
  struct Members {
    std::vector<Index> all, open;  // open: not certified
  };

  // Open bodies may stand by their own contacts and what certified ones press on them, or with
  // these: where most are open, that is asked first, as the motion that it gives if they do not
  // mostly tells of the open ones alone, too.
  void judge(const Members& part) {
    const bool mostly_open = 2 * part.open.size() >= part.all.size();
    if (!mostly_open && stands_alone(part, {})) return;
    if (part.all.size() <= m_limit)
      if (Whole* const whole = whole_of(part)) return judge_together(part, *whole, mostly_open);
    if (mostly_open && stands_alone(part, {})) return;
    // A part that is too large is judged near the change alone, and the verdict says that it does
    // not know the rest.
    m_out.known = false;
    const std::vector<Index> nearest = nearest_to_change(part.open);
    FreeBodies chosen = loaded_bodies(nearest, [&](ObjectId id, const Object& object) {
      return is_fixed_or_held(id, object) || !is_certified(id);
    });
    note(chosen, quickest_forces(chosen, m_clearance));
  }

  /// A part with all that near contacts join to it.
  struct Whole {
    FreeBodies bodies;
    PartForces forces;
    bool is_noted = false;
  };

  // Near contacts mostly join several parts to one whole. @return null: too large.
  Whole* whole_of(const Members& part) {
    const std::vector<ObjectId> ids = ids_of(part.all);
    for (Whole& whole : m_wholes)
      if (holds_all(whole.bodies, ids)) return &whole;
    FreeBodies bodies = near_part(m_scene, ids, m_clearance, is_fixed_or_held, m_friction);
    if (bodies.bodies.size() > m_limit) return nullptr;
    PartForces forces = forces_of(bodies);
    return &m_wholes.emplace_back(Whole{std::move(bodies), std::move(forces)});
  }

  static bool holds_all(const FreeBodies& whole, const std::vector<ObjectId>& ids) {
    return std::all_of(ids.begin(), ids.end(), [&](ObjectId id) {
      return std::any_of(whole.bodies.begin(), whole.bodies.end(),
                         [id](const FreeBody& body) { return body.id == id; });
    });
  }

  void judge_together(const Members& part, Whole& whole, bool may_stand_alone) {
    if (whole.is_noted || (whole.forces.solved && whole.forces.balanced())) return;
    const Larger larger{whole.bodies, whole.forces};
    if (may_stand_alone && stands_alone(part, larger)) return;
    whole.is_noted = true;
    note(whole.bodies, whole.forces);
  }

  PartForces forces_of(FreeBodies& whole) const {
    if (m_toppling == Toppling::SomeWillDo && whole.bodies.size() > kManyBodies) {
      PartForces disproof = disproof_by_few(whole, m_changed, m_clearance);
      if (disproof.solved) return disproof;
    }
    return quickest_forces(whole, m_clearance, 1, Sought::Motion);
  }

  /// A part with others, which does not stand.
  struct Larger {
    const FreeBodies& bodies;
    const PartForces& forces;
  };

  bool stands_alone(const Members& part, const std::optional<Larger>& larger) const {
    if (part.open.size() > m_limit || part.open.size() == part.all.size()) return false;
    FreeBodies open = loaded_bodies(part.open, is_fixed_or_held);
    if (part.all.size() <= m_limit && !may_all_be_held_up(open)) return false;
    if (larger && clearly_unbalanced(open, m_clearance, larger->bodies, larger->forces))
      return false;
    const PartForces forces = quickest_forces(open, m_clearance, 1, Sought::Motion);
    return forces.solved && forces.balanced();
  }

  void note(const FreeBodies& part, const PartForces& forces) {
    if (!forces.solved) m_out.known = false;
    if (!forces.solved || forces.balanced()) return;
    m_out.stands = false;
    // Bodies that the proof moves are those that topple; of many, those that do so first.
    if (part.bodies.size() > kManyBodies) {
      for (const Index i : fewest_movers(part, m_clearance, forces))
        m_out.topples.push_back(part.bodies[i].id);
      return;
    }
    for (size_t k = 0; k < part.bodies.size(); ++k)
      if (forces.moves[k]) m_out.topples.push_back(part.bodies[k].id);
  }

  std::vector<ObjectId> ids_of(const std::vector<Index>& members) const {
    std::vector<ObjectId> out;
    out.reserve(members.size());
    for (const Index i : members) out.push_back(m_ids[i]);
    return out;
  }

  FreeBodies loaded_bodies(const std::vector<Index>& open, const IsGround& is_ground) const {
    FreeBodies out = near_bodies(m_scene, ids_of(open), m_clearance, is_ground, m_friction);
    add_certified_loads(m_all, m_certificate, out);
    return out;
  }

  bool is_certified(ObjectId id) const {
    const auto at = std::lower_bound(m_ids.begin(), m_ids.end(), id, by_name(m_scene));
    return at != m_ids.end() && *at == id && m_certificate.bodies[at - m_ids.begin()].certified;
  }

  // Only open bodies can be chosen.
  std::vector<Index> nearest_to_change(const std::vector<Index>& open) const {
    std::vector<char> may(m_ids.size(), 0);
    std::vector<Index> seeds;
    for (const Index i : open) {
      may[i] = 1;
      if (std::find(m_changed.begin(), m_changed.end(), m_ids[i]) != m_changed.end())
        seeds.push_back(i);
    }
    // A change elsewhere reaches this part through bodies that are certified.
    if (seeds.empty()) seeds.push_back(open.front());
    return nearest_bodies(m_all, seeds, m_limit, may);
  }

  const Scene& m_scene;
  const std::span<const ObjectId> m_ids, m_changed;
  const double m_clearance;
  const size_t m_limit;
  const ContactFriction m_friction;
  const Toppling m_toppling;
  const FreeBodies m_all;
  const Certificate m_certificate;
  std::deque<Whole> m_wholes;
  PartVerdict m_out;
};

}  // namespace

std::vector<ObjectId> connected_with(const Scene& scene, std::span<const ObjectId> seeds) {
  std::set<std::uint32_t> seen;
  std::vector<ObjectId> out;
  const auto add = [&](ObjectId id) {
    const Object& object = scene.at(id);
    if (object.placed && !is_fixed_or_held(id, object) && seen.insert(id.index).second)
      out.push_back(id);
  };
  const auto add_partners = [&](ObjectId id) {
    for (const ObjectId member : one_body(scene, id))
      for (const ObjectContact& entry : scene.at(member).contacts)
        if (entry.with.is_object() && !entry.across_gap) add(root_of(scene, entry.with.object()));
  };
  for (const ObjectId id : seeds) add(root_of(scene, id));
  // Neighbours of a seed that stands still may have been unbalanced by it.
  for (const ObjectId id : seeds)
    if (is_fixed_or_held(id, scene.at(id))) add_partners(id);
  for (size_t i = 0; i < out.size(); ++i) add_partners(out[i]);
  std::sort(out.begin(), out.end(), by_name(scene));
  return out;
}

FreeBodies near_part(const Scene& scene, std::vector<ObjectId> ids, double clearance,
                     const IsGround& is_ground, const ContactFriction& friction,
                     double num_clearances) {
  while (true) {
    std::sort(ids.begin(), ids.end(), by_name(scene));
    // Contacts within the tolerance may reach bodies outside of the part: these join it, until none
    // is left out.
    FreeBodies part = near_bodies(scene, ids, clearance, is_ground, friction, num_clearances);
    if (part.left_out.empty()) return part;
    std::vector<ObjectId> more = connected_with(scene, part.left_out);
    more.insert(more.end(), part.left_out.begin(), part.left_out.end());
    for (const ObjectId id : more)
      if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  }
}

PartVerdict judge_parts(const Scene& scene, std::span<const ObjectId> ids,
                        std::span<const ObjectId> changed, double clearance,
                        int max_program_objects, const ContactFriction& friction,
                        Toppling toppling) {
  return Judgement(scene, ids, changed, clearance, max_program_objects, friction, toppling).run();
}

}  // namespace trivet
