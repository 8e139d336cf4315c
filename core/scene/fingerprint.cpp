#include "core/scene/fingerprint.h"

#include <algorithm>

#include "core/flex/flexible.h"
#include "core/scene/joint.h"

namespace trivet {
namespace {

void add_to(Hash& hash, const Vec3& v) {
  for (int i = 0; i < 3; ++i) hash.add(v[i]);
}

void add_to(Hash& hash, const std::vector<Index>& ids) {
  // Counts go first, so that lists do not run into each other.
  hash.add(std::uint64_t{ids.size()});
  for (const Index id : ids) hash.add(static_cast<std::uint64_t>(id));
}

void add_to(Hash& hash, const ContactPoint& p) {
  add_to(hash, p.point);
  add_to(hash, p.normal);
  hash.add(p.gap);
  hash.add(static_cast<std::uint64_t>(p.features));
  hash.add(static_cast<std::uint64_t>(p.feature_object));
  hash.add(static_cast<std::uint64_t>(p.feature_support));
}

void add_to(Hash& hash, const ObjectContact& entry) {
  const Contact& c = entry.contact;
  // The floor has a number that no slot has.
  hash.add(entry.with.is_object() ? std::uint64_t{entry.with.object().index} : ~std::uint64_t{0});
  hash.add(static_cast<std::uint64_t>(c.type));
  hash.add(std::uint64_t{c.points.size()});
  for (const ContactPoint& p : c.points) add_to(hash, p);
  hash.add(std::uint64_t{c.hull.size()});
  for (const Vec3& p : c.hull) add_to(hash, p);
  add_to(hash, c.normal);
  hash.add(c.gap);
  add_to(hash, c.faces_object);
  add_to(hash, c.faces_support);
}

void add_to(Hash& hash, const PhysicsMaterial& material) {
  hash.add(material.name).add(material.friction).add(material.density).add(material.restitution);
}

void add_to(Hash& hash, const Flexible& flexible) {
  for (const flex::Points* const points : {&flexible.vertices, &flexible.friction})
    for (const Vec3& p : *points) add_to(hash, p);
}

// A mass that is not given adds nothing: journals of earlier versions know none.
void add_to(Hash& hash, const std::optional<GivenMass>& mass) {
  if (!mass) return;
  hash.add(mass->kilograms);
  if (mass->centre) add_to(hash, *mass->centre);
  if (mass->inertia)
    for (int i = 0; i < 9; ++i) hash.add((*mass->inertia)(i / 3, i % 3));
}

void add_to(Hash& hash, const LinkJoint& joint) {
  hash.add(std::uint64_t{joint.turns()}).add(std::uint64_t{joint.parent.index});
  add_to(hash, joint.axis);
  add_to(hash, joint.anchor);
  hash.add(joint.lower).add(joint.upper).add(joint.value).add(joint.friction.value_or(-1));
}

void add_to(Hash& hash, const Scene& scene) {
  hash.add(std::uint64_t{scene.floor});
  add_to(hash, scene.floor_material);
  // Rules add nothing where there are none: states of older journals stay what they were.
  if (!scene.pair_rules) return;
  hash.add(static_cast<std::uint64_t>(scene.floor_kind));
  for (const auto& [kinds, rule] : scene.pair_rules->all()) {
    hash.add(static_cast<std::uint64_t>(kinds.first)).add(static_cast<std::uint64_t>(kinds.second));
    hash.add(std::uint64_t{rule.may_pass}).add(rule.friction.value_or(-1));
  }
}

}  // namespace

void add_to(Hash& hash, const Object& object) {
  hash.add(object.name).add(object.scale).add(object.group);
  hash.add(static_cast<std::uint64_t>(object.up));
  hash.add(static_cast<std::uint64_t>(object.state));
  // The flags share one number.
  hash.add(std::uint64_t{object.fixed} | std::uint64_t{object.placed} << 1 |
           std::uint64_t{object.locked} << 2);
  add_to(hash, object.material);
  add_to(hash, object.given_mass);
  if (object.pair_kind != 0) hash.add(static_cast<std::uint64_t>(object.pair_kind));
  const Rotation& r = object.pose.rotation;
  hash.add(r.w).add(r.x).add(r.y).add(r.z);
  add_to(hash, object.pose.translation);
  hash.add(object.stability_margin).add(object.least_friction);
  // Links across gaps follow from the rest, and journals of earlier versions know none.
  const auto is_counted = [](const ObjectContact& entry) { return !entry.across_gap; };
  // The count is of those entries that follow.
  hash.add(static_cast<std::uint64_t>(
      std::count_if(object.contacts.begin(), object.contacts.end(), is_counted)));
  for (const ObjectContact& entry : object.contacts)
    if (is_counted(entry)) add_to(hash, entry);
  if (object.flexible) add_to(hash, *object.flexible);
  if (object.joint) add_to(hash, *object.joint);
}

std::uint64_t fingerprint(const Scene& scene, std::span<const ObjectId> ids) {
  Hash hash(ids.size());
  for (const ObjectId id : ids) {
    // A slot counts even where its object is gone.
    hash.add(std::uint64_t{id.index});
    if (scene.contains(id)) add_to(hash, scene.at(id));
  }
  return hash.value();
}

std::uint64_t fingerprint(const Scene& scene) {
  Hash hash(fingerprint(scene, scene.ids()));
  add_to(hash, scene);
  return hash.value();
}

SceneState::SceneState(const Scene& scene) { update(scene, scene.ids()); }

void SceneState::update(const Scene& scene, std::span<const ObjectId> changed) {
  for (const ObjectId id : changed) {
    if (id.index >= m_slots.size()) m_slots.resize(id.index + 1);
    Slot& slot = m_slots[id.index];
    const bool here = scene.contains(id);
    // Gone, and its slot may have another object by now.
    if (!here && slot.generation != id.generation) continue;
    std::uint64_t hash = 0;
    if (here) {
      Hash of_object(id.index);
      add_to(of_object, scene.at(id));
      hash = of_object.value();
    }
    // The state is a sum over slots: a change replaces its own part alone.
    m_sum += hash - slot.hash;
    slot = {id.generation, hash};
  }
}

std::uint64_t SceneState::value(const Scene& scene) const {
  Hash hash(m_sum);
  hash.add(std::uint64_t{scene.num_objects()});
  add_to(hash, scene);
  return hash.value();
}

}  // namespace trivet
