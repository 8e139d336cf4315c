#include "ops/placement/interference.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/contact/body.h"
#include "core/contact/triangle_distance.h"
#include "core/exact/near_faces.h"
#include "core/exact/predicates.h"
#include "core/scene/friction.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

// Cosine of the angle to the direction of what stopped a motion, up to which faces do, too.
constexpr double kAlike = 0.5;
// Cosine of the angle of a face's normal to that direction, up to which the face is across it.
constexpr double kAcross = 0.1;

/// Faces of several objects, and how many more pairs are looked at.
class Collector {
 public:
  explicit Collector(int limit) : m_left(limit) {}

  bool may_go_on() { return m_left-- > 0; }
  void add(ObjectId id, Index face) {
    FacesOfObject& of = m_found[id.index];
    of.id = id;
    of.faces.push_back(face);
  }

  InterferingFaces take() {
    InterferingFaces out;
    // The result says whether the limit has cut it short.
    out.complete = m_left >= 0;
    for (auto& [slot, of] : m_found) {
      std::sort(of.faces.begin(), of.faces.end());
      of.faces.erase(std::unique(of.faces.begin(), of.faces.end()), of.faces.end());
      out.objects.push_back(std::move(of));
    }
    return out;
  }

 private:
  std::map<std::uint32_t, FacesOfObject> m_found;  // by slot
  int m_left;                                      // negative: there were too many
};

// @return whether there are any.
bool add_crossing(ObjectId id_a, const PlacedShape& a, ObjectId id_b, const PlacedShape& b,
                  Collector& out) {
  bool any = false;
  visit_near_faces(a, b, 0, [&](Index face_a, Index face_b) {
    if (!out.may_go_on()) return false;
    if (!triangles_intersect(world_triangle(a, face_a), world_triangle(b, face_b))) return true;
    any = true;
    out.add(id_a, face_a);
    out.add(id_b, face_b);
    return true;
  });
  return any;
}

// With a vertex below a height.
void add_low_faces(ObjectId id, const PlacedShape& placed, const PlacedBvh& tree, Index node,
                   double height, Collector& out) {
  // The bound grows by rounding, so that no face is missed.
  const PlacedBvh::Box box = tree.box(node);
  const double rounding = placed.slack + 1e-14 * std::abs(box.centre.z());
  if (box.centre.z() - box.half.z() - rounding > height) return;
  const BvhNode& n = tree.bvh.nodes[node];
  if (!n.is_leaf()) {
    add_low_faces(id, placed, tree, node + 1, height, out);
    add_low_faces(id, placed, tree, n.second_child, height, out);
    return;
  }
  for (Index i = n.second_child; i < n.second_child + n.num_faces; ++i) {
    const Triangle t = world_triangle(placed, tree.bvh.faces[i]);
    // The test itself is exact: coordinates are compared as they are.
    const double lowest = std::min({t[0].z(), t[1].z(), t[2].z()});
    if (lowest < height && out.may_go_on()) out.add(id, tree.bvh.faces[i]);
  }
}

void add_low_faces(ObjectId id, const PlacedShape& placed, double height, Collector& out) {
  if (!placed.shape->has_faces()) return;
  const Body body(*placed.shape, placed.world_from_object);
  add_low_faces(id, placed, PlacedBvh(body), 0, height, out);
}

void add_crossing_floor(ObjectId id, const ObjectInWorld& here, Collector& out) {
  // The exported floats may be below the floor where the doubles are not.
  if (here.box.lower.z() >= 0) return;
  if (num_below_floor(here))
    add_low_faces(id, here.doubles, 0, out);
  else
    add_low_faces(id, here.floats, -here.origin.z(), out);
}

/// A face near another, and the direction from that which stands to that which moves: unit; zero
/// when they touch.
struct NearFace {
  ObjectId id;
  Index face;
  bool looks_there;  // its normal is not across that direction
};
struct NearPair {
  NearFace moved, fixed;
  Vec3 towards;
  double squared_distance;  // from where the motion was stopped
};

bool looks_along(const Triangle& t, const Vec3& direction) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  return std::abs(normal.dot(direction)) > kAcross * normal.norm();
}

/// A placed object.
struct Placed {
  ObjectId id;
  Body body;
  PlacedShape shape;

  Placed(const Object& object, const Placement& where)
      : id(where.id),
        body(body_of(object, where.pose)),
        shape{object.shape.get(), nullptr, body.world_from_object, 0, {}} {}
};

void find_near_pairs(const Placed& moved, const Placed& fixed, const Vec3& stopped_at,
                     double tolerance, Collector& out, std::vector<NearPair>& found) {
  visit_near_faces(moved.shape, fixed.shape, tolerance, [&](Index face_moved, Index face_fixed) {
    if (!out.may_go_on()) return false;
    const Triangle a = world_triangle(moved.shape, face_moved),
                   b = world_triangle(fixed.shape, face_fixed);
    const ClosestPoints c = closest_points(a, b);
    if (c.distance > tolerance) return true;
    // Faces that touch have no direction between them, and count as looking there.
    const bool apart = c.features != ClosestPoints::Features::Crossing && c.distance > 0;
    const Vec3 towards = apart ? Vec3((c.point_a - c.point_b) / c.distance) : Vec3(Vec3::Zero());
    found.push_back({{moved.id, face_moved, !apart || looks_along(a, towards)},
                     {fixed.id, face_fixed, !apart || looks_along(b, towards)},
                     towards,
                     apart ? (c.point_b - stopped_at).squaredNorm() : kInfinity});
    return true;
  });
}

// Faces of pairs in about the direction of the pair nearest to where the motion was stopped. If
// some of an object's faces look there, only these: the side of a box that runs into a wall, not
// those that reach it with an edge.
void add_those_alike(const std::vector<NearPair>& found, Collector& out) {
  const auto nearest = std::min_element(
      found.begin(), found.end(),
      [](const NearPair& a, const NearPair& b) { return a.squared_distance < b.squared_distance; });
  std::vector<NearFace> faces;
  std::set<std::uint32_t> look_there;  // slots
  // The direction of the pair nearest to the stop is that of the blockage.
  for (const NearPair& pair : found) {
    if (pair.towards != Vec3::Zero() && pair.towards.dot(nearest->towards) < kAlike) continue;
    for (const NearFace& face : {pair.moved, pair.fixed}) {
      faces.push_back(face);
      if (face.looks_there) look_there.insert(face.id.index);
    }
  }
  for (const NearFace& face : faces)
    if (face.looks_there || !look_there.count(face.id.index)) out.add(face.id, face.face);
}

}  // namespace

InterferingFaces crossing_faces(const Scene& scene, std::span<const Placement> moved, int limit) {
  Collector out(limit);
  std::vector<ObjectId> ids;
  for (const Placement& placement : moved) ids.push_back(placement.id);
  // Bodies that move together do not stop each other.
  const Neighbourhood outside(scene, ids);
  const Vec3 origin = origin_with(scene, moved);
  for (const Placement& placement : moved) {
    const Object& object = scene.at(placement.id);
    const ObjectInWorld here = in_world(object, placement.pose, origin);
    if (scene.floor && !may_pass_floor(scene, object)) add_crossing_floor(placement.id, here, out);
    // Crossings of the exported floats are shown only where the doubles have none.
    bool any = false;
    std::vector<std::pair<ObjectId, ObjectInWorld>> others;
    for (const ObjectId id : outside.ids_near(here.box, here.floats.slack)) {
      const Object& other = scene.at(id);
      others.emplace_back(id, in_world(other, other.pose, origin));
      any |= add_crossing(placement.id, here.doubles, id, others.back().second.doubles, out);
    }
    for (size_t i = 0; i < others.size() && !any; ++i)
      add_crossing(placement.id, here.floats, others[i].first, others[i].second.floats, out);
  }
  return out.take();
}

InterferingFaces blocking_faces(const Scene& scene, std::span<const Placement> moved,
                                const Blockage& blockage, double tolerance, int limit) {
  Collector out(limit);
  std::optional<Placed> by;
  if (blockage.by.is_object()) {
    const ObjectId id = blockage.by.object();
    if (!scene.contains(id)) return {};
    by.emplace(scene.at(id), Placement{id, scene.at(id).pose});
  }
  std::vector<NearPair> found;
  // A floor stops by its height, an object by the faces that are near.
  for (const Placement& placement : moved) {
    const Placed here(scene.at(placement.id), placement);
    if (!by)
      add_low_faces(here.id, here.shape, tolerance, out);
    else if (overlaps(here.body.world_box, by->body.world_box, 1.001 * tolerance))
      find_near_pairs(here, *by, blockage.at, tolerance, out, found);
  }
  add_those_alike(found, out);
  return out.take();
}

}  // namespace trivet
