#include "apps/edit/document/remake.h"

#include <algorithm>

namespace trivet::edit {
namespace {

constexpr double kMostSpread = 4;  // of what it carries: a wrong unit scales by more

DeleteOperation erase(const std::string& name) {
  DeleteOperation out;
  out.object = name;
  return out;
}

/// @param name  of the object that takes the place of `old`.
void keep_properties(const Object& old, const std::string& name, OperationGroup& group) {
  if (!old.group.empty()) group.push_back(GroupOperation{name, old.group});
  if (old.locked) group.push_back(LockOperation{name, true});
}

/// An object in another scale or with another axis up, with what it carries.
class Remade {
 public:
  Remade(const SceneSnapshot& scene, const ObjectSnapshot& old, double scale, UpAxis up,
         double drop_height)
      : m_old(*old.object), m_new(m_old), m_drop_height(drop_height) {
    m_new.scale = scale;
    m_new.up = up;
    for (const ObjectId id : with_loads(scene, old.id))
      if (id != old.id && m_old.placed) m_loads.push_back(scene.find(id)->object.get());
  }

  /// @param lift  of the start, metres above its place.
  OperationGroup group(double lift) const {
    OperationGroup out;
    if (m_old.locked) out.push_back(LockOperation{m_old.name, false});
    out.push_back(erase(m_old.name));
    out.push_back(append());
    for (size_t i = m_loads.size(); i-- > 0;) {
      UnplaceOperation unplace;
      unplace.object = m_loads[i]->name;
      out.push_back(unplace);
    }
    if (m_old.placed) out.push_back(put(lift));
    for (const Object* const load : m_loads) out.push_back(put_again(*load, lift));
    keep_properties(m_old, m_old.name, out);
    return out;
  }

 private:
  AppendOperation append() const {
    AppendOperation out;
    out.object = m_old.name;
    out.model = m_old.model->path;
    out.tessellation = m_old.model->tessellation;
    out.scale = m_new.scale;
    out.up = m_new.up;
    out.fixed = m_old.fixed;
    out.material = m_old.material;
    return out;
  }

  PutOperation put(double lift) const {
    PutOperation out;
    out.object = m_old.name;
    out.start = start_in_place_of(m_old, m_new, m_drop_height + lift);
    if (lift <= 0) out.tries = 1;  // it stays where it was, or the change is refused
    return out;
  }

  /// Over the same part of the object, as high over its top as before.
  PutOperation put_again(const Object& load, double lift) const {
    Object there = m_new;
    there.pose = start_in_place_of(m_old, m_new, m_drop_height + lift);
    const Vec3 before = m_old.centre_of_mass(), now = there.centre_of_mass();
    const double ratio = std::min(m_new.scale / m_old.scale, kMostSpread);
    PutOperation out;
    out.object = load.name;
    out.start = load.pose;
    const Vec2 aside = (load.centre_of_mass() - before).head<2>();
    out.start.translation.head<2>() += (now - before).head<2>() + (ratio - 1) * aside;
    out.start.translation.z() +=
        world_box(there).upper.z() - world_box(m_old).upper.z() + m_drop_height;
    return out;
  }

  const Object& m_old;
  Object m_new;
  std::vector<const Object*> m_loads;  // lower ones first
  double m_drop_height;
};

}  // namespace

Pose start_in_place_of(const Object& old, Object there, double drop_height) {
  there.pose = {old.pose.rotation, Vec3::Zero()};
  Vec3 to = old.centre_of_mass() - there.centre_of_mass();
  to.z() = world_box(old).lower.z() - world_box(there).lower.z() + drop_height;
  return {old.pose.rotation, to};
}

std::vector<OperationGroup> rescaling(const SceneSnapshot& scene, const std::string& name,
                                      double scale, UpAxis up, double drop_height) {
  const ObjectSnapshot* const found = scene.find(name);
  if (!found || !(*found)->model) return {};
  const Remade remade(scene, *found, scale, up, drop_height);
  if (!(*found)->placed) return {remade.group(0)};
  const Aabb all = scene.box();
  const double above = all.upper.z() - world_box(*found->object).lower.z();
  return {remade.group(0), remade.group(above)};
}

}  // namespace trivet::edit
