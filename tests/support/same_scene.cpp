#include "support/same_scene.h"

#include <algorithm>

#include "core/scene/joint.h"
#include "core/scene/materials.h"

namespace trivet::test {
namespace {

bool same(const Pose& a, const Pose& b) {
  return a.rotation.w == b.rotation.w && a.rotation.x == b.rotation.x &&
         a.rotation.y == b.rotation.y && a.rotation.z == b.rotation.z &&
         a.translation == b.translation;
}

bool same(const ContactPoint& a, const ContactPoint& b) {
  return a.point == b.point && a.normal == b.normal && a.gap == b.gap && a.features == b.features &&
         a.feature_object == b.feature_object && a.feature_support == b.feature_support;
}

bool same(const Contact& x, const Contact& y) {
  return x.type == y.type && x.hull == y.hull && x.normal == y.normal && x.gap == y.gap &&
         x.faces_object == y.faces_object && x.faces_support == y.faces_support &&
         std::equal(x.points.begin(), x.points.end(), y.points.begin(), y.points.end(),
                    [](const ContactPoint& p, const ContactPoint& q) { return same(p, q); });
}

// But for the parent's id.
bool same(const LinkJoint& a, const LinkJoint& b) {
  return a.kind == b.kind && a.axis == b.axis && a.anchor == b.anchor && a.lower == b.lower &&
         a.upper == b.upper && a.value == b.value && a.friction == b.friction &&
         same(a.parent_then, b.parent_then) && same(a.at_zero, b.at_zero);
}

// @param same_partner  of two supports.
template <class SamePartner>
std::string difference(const Object& a, const Object& b, const SamePartner& same_partner) {
  if (a.name != b.name) return "name";
  if (a.up != b.up || a.scale != b.scale) return "scale";
  if (!same_material(a.material, b.material)) return "material";
  if (a.locked != b.locked || a.group != b.group) return "lock or group";
  if (a.fixed != b.fixed || a.placed != b.placed || a.state != b.state) return "state";
  if (!same(a.pose, b.pose)) return "pose";
  if (!a.joint != !b.joint || (a.joint && !same(*a.joint, *b.joint))) return "joint";
  if (a.stability_margin != b.stability_margin || a.least_friction != b.least_friction)
    return "rating";
  const bool object_contacts =
      std::equal(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end(),
                 [&](const ObjectContact& x, const ObjectContact& y) {
                   return same_partner(x.with, y.with) && same(x.contact, y.contact);
                 });
  return object_contacts ? "" : "links";
}

std::string difference(const Object& a, const Object& b) {
  if (a.model != b.model || a.shape != b.shape || a.flexible != b.flexible) return "model";
  return difference(a, b, [](const Support& x, const Support& y) { return x == y; });
}

}  // namespace

std::string difference(const Scene& a, const Scene& b) {
  if (a.floor != b.floor || !same_material(a.floor_material, b.floor_material)) return "floor";
  if (a.ids() != b.ids()) return "ids";
  for (const ObjectId id : a.ids())
    if (const std::string d = difference(a.at(id), b.at(id)); !d.empty())
      return d + " of " + a.at(id).name;
  return "";
}

std::string difference_in_file(const Scene& a, const Scene& b) {
  if (a.floor != b.floor || !same_material(a.floor_material, b.floor_material)) return "floor";
  const std::vector<ObjectId> of_a = a.ids(), of_b = b.ids();
  if (of_a.size() != of_b.size()) return "number of objects";
  const auto same_partner = [&](const Support& x, const Support& y) {
    if (x.is_floor() || y.is_floor()) return x.is_floor() && y.is_floor();
    return a.at(x.object()).name == b.at(y.object()).name;
  };
  for (size_t i = 0; i < of_a.size(); ++i) {
    const Object &p = a.at(of_a[i]), &q = b.at(of_b[i]);
    if (p.shape->mesh.vertices != q.shape->mesh.vertices) return "mesh of " + p.name;
    if (const std::string d = difference(p, q, same_partner); !d.empty())
      return d + " of " + p.name;
  }
  return "";
}

}  // namespace trivet::test
