#include "ops/placement/neighbourhood.h"

#include <algorithm>

#include "core/scene/friction.h"
#include "ops/detect/detector.h"
#include "ops/placement/slot_order.h"

namespace trivet {
namespace {

// Box of everything that a motion may come near.
Aabb swept_box(Aabb box, const Motion& motion, double margin) {
  // A translation sweeps the box; a turn stays within the ball through its farthest corner.
  if (motion.kind == Motion::Kind::Translation) {
    const Vec3 way = motion.limit * motion.axis;
    box.extend(Aabb{box.lower + way, box.upper + way});
  } else {
    const Vec3 far = (box.centre() - motion.centre).cwiseAbs() + box.half_extent();
    const Vec3 reach = Vec3::Constant(far.norm() * (1 + 1e-14));
    box = {motion.centre - reach, motion.centre + reach};
  }
  box.lower -= Vec3::Constant(margin), box.upper += Vec3::Constant(margin);
  return box;
}

}  // namespace

Body body_of(const Object& object, const Pose& pose) {
  return {*object.shape, world_from_object(pose, object.up, object.scale)};
}

Body body_of(const Object& object) { return body_of(object, object.pose); }

double size_of(const Object& object) { return object.scale * object.shape->box.diagonal(); }

Neighbourhood::Neighbourhood(const Scene& scene, std::span<const ObjectId> without)
    : m_scene(&scene), m_without(without.begin(), without.end()), m_floor(scene.floor) {
  std::sort(m_without.begin(), m_without.end(), by_slot);
  // Rules that let pairs pass leave out those that none of the moving bodies can meet.
  if (!scene.pair_rules) return;
  for (const ObjectId id : m_without) m_passing.push_back(scene.at(id).pair_kind);
  if (may_be_passed(scene.floor_kind)) m_floor = false;
}

Neighbourhood::Neighbourhood(const Scene& scene, ObjectId without)
    : Neighbourhood(scene, std::span<const ObjectId>(&without, 1)) {}

void Neighbourhood::leave_out(std::span<const Support> left_out) {
  for (const Support& out : left_out)
    if (out.is_floor())
      m_floor = false;
    else
      m_without.push_back(out.object());
  std::sort(m_without.begin(), m_without.end(), by_slot);
}

bool Neighbourhood::may_be_passed(PairKind kind) const {
  return !m_passing.empty() &&
         std::all_of(m_passing.begin(), m_passing.end(),
                     [&](PairKind moving) { return may_pass(*m_scene, moving, kind); });
}

bool Neighbourhood::excludes(ObjectId id) const {
  return std::binary_search(m_without.begin(), m_without.end(), id, by_slot) ||
         may_be_passed(m_scene->at(id).pair_kind);
}

std::vector<ObjectId> Neighbourhood::ids_near(const Aabb& box, double margin) const {
  std::vector<ObjectId> out = m_scene->near(box, margin);
  std::erase_if(out, [&](ObjectId id) { return excludes(id); });
  return out;
}

Neighbours Neighbourhood::near(const Aabb& box, double margin) const {
  Neighbours out;
  out.ids = ids_near(box, margin);
  out.bodies.reserve(out.ids.size());
  for (const ObjectId id : out.ids) out.bodies.push_back(body_of(m_scene->at(id)));
  return out;
}

Aabb Neighbourhood::box() const { return m_scene->extent_without(m_without).box; }

namespace {

// Finds the neighbours that a motion of these bodies may meet.
class NearMotion {
 public:
  explicit NearMotion(std::span<const Body> moving) {
    for (const Body& body : moving)
      if (!body.world_box.empty()) m_box.extend(body.world_box);
  }
  Neighbours find(const Neighbourhood& others, const Motion& motion,
                  const Clearance& clearance) const {
    // The margin covers the largest stop and rounding.
    const double margin = 1.01 * clearance.largest_stop() + 1e-13 * m_box.max_abs_coordinate();
    return others.near(swept_box(m_box, motion, margin), 0);
  }

 private:
  Aabb m_box;
};

ObstacleContact with_obstacle(const FirstContact& found, const Neighbours& near) {
  ObstacleContact out{found, Support::floor()};
  if (found.status != FirstContact::Status::Free && found.fixed != FirstContact::kFloor)
    out.with = near.ids[found.fixed];
  return out;
}

}  // namespace

ObstacleContact first_contact(std::span<const Body> moving, const Neighbourhood& others,
                              const Motion& motion, const Clearance& clearance, Detector* detector,
                              SeparatingPlanes* planes) {
  const Neighbours near = NearMotion(moving).find(others, motion, clearance);
  const FirstContactQuery query{moving, near.bodies, others.floor(), motion, clearance, planes};
  return with_obstacle(detector ? detector->first_contact(query) : first_contact(query), near);
}

std::vector<ObstacleContact> first_contacts_early(std::span<const Body> moving,
                                                  const Neighbourhood& others,
                                                  std::span<const Motion> motions,
                                                  const Clearance& clearance, Detector& detector,
                                                  SeparatingPlanes* planes) {
  const NearMotion near_motion(moving);
  // Each motion has neighbours of its own; all queries are asked together.
  std::vector<Neighbours> near;
  for (const Motion& motion : motions) near.push_back(near_motion.find(others, motion, clearance));
  std::vector<FirstContactQuery> queries;
  for (size_t i = 0; i < motions.size(); ++i)
    queries.push_back({moving, near[i].bodies, others.floor(), motions[i], clearance, planes});
  const std::vector<FirstContact> found = detector.first_contacts_early(queries);
  std::vector<ObstacleContact> out;
  for (size_t i = 0; i < motions.size(); ++i) out.push_back(with_obstacle(found[i], near[i]));
  return out;
}

}  // namespace trivet
