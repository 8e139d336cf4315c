#include "ops/stability/part.h"

#include <algorithm>
#include <set>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/friction.h"
#include "ops/placement/contacts.h"
#include "ops/placement/slot_order.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/settle.h"
#include "ops/stability/certificate.h"
#include "ops/stability/contact_forces.h"

namespace trivet {
namespace {

bool stands_still(const Object& object) {
  return object.fixed || object.state == ObjectState::Held;
}

// Where the ids have it; ground: nowhere.
Index find_body(std::span<const ObjectId> ids, const Support& with) {
  if (with.is_floor()) return BodyContact::kGround;
  const auto at = std::lower_bound(ids.begin(), ids.end(), with.object(), by_slot);
  return at != ids.end() && at->index == with.object().index ? static_cast<Index>(at - ids.begin())
                                                             : BodyContact::kGround;
}

FreeBodies bodies_only(const Scene& scene, std::span<const ObjectId> ids) {
  FreeBodies out;
  for (const ObjectId id : ids) {
    const Object& object = scene.at(id);
    out.bodies.push_back({id, object.centre_of_mass(), weight_of(object), size_of(object)});
  }
  return out;
}

// With the contacts of the scene's links.
FreeBodies linked_bodies(const Scene& scene, std::span<const ObjectId> ids) {
  FreeBodies out = bodies_only(scene, ids);
  for (Index i = 0; i < static_cast<Index>(ids.size()); ++i)
    for (const ObjectContact& entry : scene.at(ids[i]).contacts) {
      const Index from = find_body(ids, entry.with);
      if (from != BodyContact::kGround && from < i) continue;  // seen from the other side already
      const double friction = friction_between(scene, ids[i], entry.with);
      for (const ContactPoint& p : entry.contact.points)
        out.touches.push_back({i, from, entry.with, friction, p});
    }
  return out;
}

}  // namespace

std::vector<ObjectId> connected_with(const Scene& scene, std::span<const ObjectId> seeds) {
  std::set<std::uint32_t> seen;
  std::vector<ObjectId> out;
  const auto add = [&](ObjectId id) {
    const Object& object = scene.at(id);
    if (object.placed && !stands_still(object) && seen.insert(id.index).second) out.push_back(id);
  };
  const auto add_partners = [&](ObjectId id) {
    for (const ObjectContact& entry : scene.at(id).contacts)
      if (entry.with.is_object()) add(entry.with.object());
  };
  for (const ObjectId id : seeds) add(id);
  // What touches a seed that stands still may have been unbalanced by it.
  for (const ObjectId id : seeds)
    if (stands_still(scene.at(id))) add_partners(id);
  for (size_t i = 0; i < out.size(); ++i) add_partners(out[i]);
  std::sort(out.begin(), out.end(), by_slot);
  return out;
}

FreeBodies near_bodies(const Scene& scene, std::span<const ObjectId> ids, double clearance,
                       std::optional<double> friction) {
  FreeBodies out = bodies_only(scene, ids);
  const double tolerance = kBalanceTolerance * clearance;
  for (Index i = 0; i < static_cast<Index>(ids.size()); ++i)
    for (const ContactsWith& c :
         contacts_with(body_of(scene.at(ids[i])), Neighbourhood(scene, ids[i]), tolerance,
                       kFootSlack * clearance)) {
      const Index from = find_body(ids, c.with);
      if (from != BodyContact::kGround && from <= i) continue;
      if (from == BodyContact::kGround && c.with.is_object() &&
          !stands_still(scene.at(c.with.object())))
        continue;
      const double of_pair = friction.value_or(friction_between(scene, ids[i], c.with));
      for (const ContactPoint& p : reduced(merged(c.points, tolerance), kPairContacts))
        out.touches.push_back({i, from, c.with, of_pair, p});
    }
  return out;
}

double balance_tolerance(const FreeBodies& part, double clearance) {
  double largest = 0;
  for (const FreeBody& body : part.bodies)
    largest = std::max(largest, residual_tolerance(body.size, clearance));
  return largest;
}

PartVerdict judge_parts(const Scene& scene, std::span<const ObjectId> ids, double clearance,
                        int max_program_objects) {
  PartVerdict out;
  const FreeBodies all = linked_bodies(scene, ids);
  const Certificate certificate = vertical_certificate(all);
  const std::vector<Index> part_of = connected_parts(all);
  const Index num_parts =
      part_of.empty() ? 0 : 1 + *std::max_element(part_of.begin(), part_of.end());
  std::vector<std::vector<ObjectId>> members(num_parts);
  std::vector<char> failed(num_parts, 0);
  for (size_t i = 0; i < part_of.size(); ++i) {
    members[part_of[i]].push_back(ids[i]);
    if (!certificate.bodies[i].certified) failed[part_of[i]] = 1;
  }
  for (Index p = 0; p < num_parts; ++p) {
    if (!failed[p]) continue;
    if (static_cast<int>(members[p].size()) > max_program_objects) {
      out.known = false;
      continue;
    }
    const FreeBodies part = near_bodies(scene, members[p], clearance, std::nullopt);
    const PartForces forces = contact_forces(part);
    if (!forces.solved) out.known = false;
    if (!forces.solved || forces.residual <= balance_tolerance(part, clearance)) continue;
    out.stands = false;
    for (size_t k = 0; k < members[p].size(); ++k)
      if (forces.moves[k]) out.topples.push_back(members[p][k]);
  }
  std::sort(out.topples.begin(), out.topples.end(), by_slot);
  return out;
}

}  // namespace trivet
