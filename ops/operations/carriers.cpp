#include "ops/operations/carriers.h"

#include <algorithm>

#include "core/base/tunables.h"
#include "ops/stability/contact_forces.h"

namespace trivet {
namespace {

bool leans_on_others(const Object& object) {
  return object.placed && !object.fixed && leans(object);
}

// The other contacts do not balance the body.
bool is_needed(FreeBodies alone, const Support& partner, double clearance) {
  const auto is_its = [&](const BodyContact& t) { return t.partner == partner; };
  std::erase_if(alone.touches, is_its);
  std::erase_if(alone.more, is_its);
  if (quickly_balanced(alone, clearance)) return false;
  const PartForces others = contact_forces(alone, clearance);
  return others.solved && !others.balanced();
}

// Carriers of one body among others that stand still; nothing: its contacts do not balance it.
std::optional<std::vector<ContactsWith>> carriers_among(FreeBodies alone, double clearance) {
  // The forces that balance the body alone tell how much of its weight each partner bears.
  const PartForces found = contact_forces(alone, clearance);
  if (!found.solved || !found.balanced()) return std::nullopt;
  std::vector<ContactsWith> partners;
  std::vector<double> upward;
  for (size_t k = 0; k < alone.touches.size(); ++k) {
    const BodyContact& t = alone.touches[k];
    const auto same = [&](const ContactsWith& c) { return c.with == t.partner; };
    auto at = std::find_if(partners.begin(), partners.end(), same);
    if (at == partners.end()) {
      at = partners.insert(at, {t.partner, {}});
      upward.push_back(0);
    }
    at->points.push_back(t.contact);
    upward[static_cast<size_t>(at - partners.begin())] += found.forces[k].z();
  }
  std::vector<ContactsWith> out;
  // A partner that bears next to nothing merely touches, unless the object would fall without it:
  // friction leaves open how much a steep one bears.
  for (size_t k = 0; k < partners.size(); ++k)
    if (upward[k] > kCarriedPart * alone.bodies[0].weight ||
        is_needed(alone, partners[k].with, clearance))
      out.push_back(std::move(partners[k]));
  return out;
}

std::vector<ContactsWith> carriers(const Scene& scene, ObjectId id, const RestRules& rules) {
  std::optional<double> friction;
  if (rules.perfect_friction) friction = kLargestFriction;
  const ObjectId ids[] = {id};
  // Contacts that the scene knows are asked first; those farther away only if the close ones do not
  // hold it.
  if (auto close = carriers_among(linked_bodies(scene, ids, {friction}), rules.clearance))
    return std::move(*close);
  const auto is_ground = [](ObjectId, const Object&) { return true; };
  const double reach = rules.perfect_friction ? kBalanceTolerance : kCarryingTolerance;
  return carriers_among(near_bodies(scene, ids, rules.clearance, is_ground, {friction}, reach),
                        rules.clearance)
      .value_or(std::vector<ContactsWith>{});
}

bool are_marked_alike(const std::vector<ObjectContact>& a, const std::vector<ObjectContact>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const ObjectContact& x, const ObjectContact& y) {
        return x.with == y.with && x.across_gap == y.across_gap && x.carries == y.carries;
      });
}

}  // namespace

void link_carriers(Transaction& transaction, ObjectId id, const RestRules& rules) {
  const Scene& scene = transaction.scene();
  const Object& object = scene.at(id);
  std::vector<ObjectContact> links = object.contacts;
  const auto is_marked = [](const ObjectContact& l) { return l.carries || l.across_gap; };
  // An object that stands on what lies below it needs no marks, and loses those it had.
  if (!leans_on_others(object) && std::none_of(links.begin(), links.end(), is_marked)) return;
  for (ObjectContact& l : links) l.carries = false;
  std::erase_if(links, [](const ObjectContact& l) { return l.across_gap && !l.is_carried; });
  if (leans_on_others(object))
    for (const ContactsWith& c : carriers(scene, id, rules)) {
      const auto same = [&](const ObjectContact& l) { return l.with == c.with; };
      // A carrier across a gap is no contact yet, and becomes a link of its own.
      auto at = std::find_if(links.begin(), links.end(), same);
      if (at == links.end()) {
        at = links.insert(
            at, object_contacts_of(object, object.pose, scene, {c}, rules.clearance).front());
        at->across_gap = true;
      }
      at->carries = true;
    }
  // Links that stay as they are are not written, so that nothing counts as touched.
  if (!are_marked_alike(links, object.contacts)) transaction.set_contacts(id, std::move(links));
}

}  // namespace trivet
