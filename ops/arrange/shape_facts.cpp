#include "ops/arrange/shape_facts.h"

#include "ops/arrange/outline.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {
namespace {

// The value of a key, made when it is asked for first.
template <class Map, class Make>
const typename Map::mapped_type& known(Map& map, const typename Map::key_type& key, Make make) {
  const auto it = map.find(key);
  return it == map.end() ? map.emplace(key, make()).first->second : it->second;
}

}  // namespace

bool ShapeFacts::stands_as_modelled(const Object& object) {
  return known(m_stands, {object.shape, object.up, object.scale},
               [&] { return trivet::stands_as_modelled(*object.shape, object.up, object.scale); });
}

const std::vector<Vec3>& ShapeFacts::hull(const Object& object) {
  // A thing that stands as it was modelled needs no hull: all its points do as well, and cost less
  // than Qhull.
  return known(m_hulls, object.shape, [&] {
    return stands_as_modelled(object) ? object.shape->mesh.vertices : hull_points(*object.shape);
  });
}

// Its hull is kept, too, but of points in one plane, of which it is all points.
const std::vector<StablePose>& ShapeFacts::poses(const Object& object) {
  return known(m_poses, {object.shape, object.up, object.scale}, [&] {
    std::vector<Index> ids;
    auto out = stable_poses(*object.shape, object.up, object.scale, &ids);
    const bool is_flat = ids.size() == object.shape->mesh.vertices.size();
    std::vector<Vec3> points;
    points.reserve(ids.size());
    for (const Index v : ids) points.push_back(object.shape->mesh.vertices[v]);
    if (!is_flat) m_hulls.emplace(object.shape, std::move(points));
    return out;
  });
}

const std::vector<SupportSurface>& ShapeFacts::surfaces(const Object& object) {
  const Affine place = object.world_from_object();
  // Surfaces depend on where the object stands, so that its place is part of the key.
  std::vector<double> key(place.linear.data(), place.linear.data() + place.linear.size());
  key.insert(key.end(), place.translation.data(), place.translation.data() + 3);
  return known(m_surfaces, {object.shape, std::move(key)},
               [&] { return support_surfaces(body_of(object)); });
}

}  // namespace trivet
