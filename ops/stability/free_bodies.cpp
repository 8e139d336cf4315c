#include "ops/stability/free_bodies.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/scene/friction.h"

namespace trivet {

FreeBodies free_bodies(const Scene& scene, std::optional<double> friction) {
  FreeBodies out;
  std::map<std::uint32_t, Index> body_index;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed || object.fixed) continue;
    body_index[id.index] = static_cast<Index>(out.bodies.size());
    out.bodies.push_back({id, object.centre_of_mass(), weight_of(object),
                          object.scale * object.shape->box.diagonal()});
  }
  for (Index i = 0; i < static_cast<Index>(out.bodies.size()); ++i)
    for (const ObjectContact& entry : scene.at(out.bodies[i].id).contacts) {
      const auto other =
          entry.with.is_object() ? body_index.find(entry.with.object().index) : body_index.end();
      const Index from = other == body_index.end() ? BodyContact::kGround : other->second;
      if (from != BodyContact::kGround && from < i) continue;  // seen from the other side already
      const double mu = friction.value_or(friction_between(scene, out.bodies[i].id, entry.with));
      for (const ContactPoint& p : entry.contact.points)
        out.touches.push_back({i, from, entry.with, mu, p});
    }
  return out;
}

std::vector<Index> connected_parts(const FreeBodies& all) {
  std::vector<Index> root(all.bodies.size());
  std::iota(root.begin(), root.end(), 0);
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
