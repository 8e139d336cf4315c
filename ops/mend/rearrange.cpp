#include "ops/mend/rearrange.h"

#include <algorithm>

#include "ops/check/check.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "ops/placement/depth.h"

namespace trivet {
namespace {

constexpr double kSpreadAir = 2e-5;  // metres between them afterwards
constexpr int kSweeps = 80;          // a row of twelve needs about fifty

class Spreader {
 public:
  Spreader(const Scene& scene, const std::vector<Placement>& members, double most)
      : m_scene(scene),
        m_members(members),
        m_most(most),
        m_origin(origin_with(scene, members)),
        m_shifts(members.size(), Vec3::Zero()) {
    for (const Placement& p : m_members) m_worlds.push_back(world_of(p));
  }

  std::vector<Vec3> run() {
    for (int sweep = 0; sweep < kSweeps; ++sweep)
      if (!sweep_once()) break;
    return m_shifts;
  }

 private:
  ObjectInWorld world_of(const Placement& p) const {
    return in_world(m_scene.at(p.id), p.pose, m_origin);
  }

  bool sweep_once() {
    bool moved = false;
    for (size_t i = 0; i < m_members.size(); ++i) {
      for (size_t j = 0; j < i; ++j)
        if (const Vec3 way = way_out(m_worlds[i], m_worlds[j]); way.norm() > 0) {
          shift(i, 0.5 * way), shift(j, -0.5 * way);
          moved = true;
        }
      moved |= leave_the_scene(i);
    }
    return moved;
  }

  // The objects of the scene stay.
  bool leave_the_scene(size_t i) {
    bool moved = false;
    for (const Interpenetration& x : interpenetrations(m_scene, {&m_members[i], 1}, false, 8)) {
      if (x.with.is_floor()) continue;
      const ObjectId other = x.with.object();
      const Vec3 way = way_out(m_worlds[i], world_of({other, m_scene.at(other).pose}));
      if (way.norm() > 0) shift(i, way), moved = true;
    }
    return moved;
  }

  // Zero: they are apart, or not to be parted sideways.
  Vec3 way_out(const ObjectInWorld& a, const ObjectInWorld& b) const {
    if (!overlaps(a.box, b.box) || verify_pair(a, b, false, 1).clear()) return Vec3::Zero();
    const Depth depth = depth_of(a, b);
    if (depth.metres > m_most || depth.way.head<2>().norm() < std::abs(depth.way.z()))
      return Vec3::Zero();
    return (depth.metres + kSpreadAir) * Vec3(depth.way.x(), depth.way.y(), 0);
  }

  void shift(size_t i, const Vec3& by) {
    m_shifts[i] += by;
    m_members[i].pose.translation += by;
    m_worlds[i] = world_of(m_members[i]);
  }

  const Scene& m_scene;
  std::vector<Placement> m_members;
  double m_most;
  Vec3 m_origin;
  std::vector<Vec3> m_shifts;
  std::vector<ObjectInWorld> m_worlds;
};

}  // namespace

template <class Target>
OperationResult Rearrangement::put_in(Target& target, ObjectId id, const Pose& start) {
  PutOperation put;
  put.object = m_scene.at(id).name;
  put.start = start;
  RunContext context = m_options.context;
  if (m_options.seconds > 0)  // one that takes long ends with the whole
    context.time_budget_s = std::max(m_options.seconds - 1e-3 * m_watch.milliseconds(), 1e-3);
  return perform(target, Operation(put), m_options.settle, context);
}
template OperationResult Rearrangement::put_in(Scene&, ObjectId, const Pose&);
template OperationResult Rearrangement::put_in(Transaction&, ObjectId, const Pose&);

Rearrangement::Rearrangement(Scene& scene, const SettleSceneOptions& options,
                             const std::vector<ObjectId>& ids)
    : m_scene(scene), m_options(options) {
  for (const ObjectId id : ids) m_given[id.index] = scene.at(id).pose;
  // All leave the scene at once, so that none is in the way of another's place.
  for (const ObjectId id : ids) edit_object(scene, id, [](Object& o) { o.placed = false; });
  update_contacts(scene, options.settle.clearance, options.settle);
}

bool Rearrangement::is_out_of_time() const {
  return m_options.seconds > 0 && m_watch.milliseconds() > 1000 * m_options.seconds;
}

bool Rearrangement::keep(ObjectId id) {
  // The object is kept only if it stands there and is stable.
  Transaction transaction(m_scene);
  StandOperation there;
  there.object = m_scene.at(id).name;
  there.pose = given(id);
  const OperationResult result =
      perform(transaction, Operation(there), m_options.settle, m_options.context);
  if (!result.ok() || m_scene.at(id).state != ObjectState::Stable) return false;
  transaction.commit();
  return true;
}

SettledScene Rearrangement::finish() {
  // Objects that found no place go back to where they were, marked invalid.
  for (const UnsettledObject& u : m_out.unable)
    edit_object(m_scene, u.id, [&](Object& o) {
      o.pose = given(u.id);
      o.placed = true;
      o.state = ObjectState::Invalid;
    });
  update_contacts(m_scene, m_options.settle.clearance, m_options.settle);
  for (const ObjectId id : m_scene.ids()) {
    // Ways and turns are measured from the given poses.
    const auto it = m_given.find(id.index);
    if (it == m_given.end()) continue;
    const Object& object = m_scene.at(id);
    const Vec3 was =
        world_from_object(it->second, object.up, object.scale).apply(object.shape->mass.centre);
    const double moved = (object.centre_of_mass() - was).norm();
    const double turned = turn_between_deg(it->second.rotation, object.pose.rotation);
    if (moved > 0 || turned > 0)
      m_out.moved.push_back({id, object.name, it->second, object.pose, moved, turned});
  }
  return std::move(m_out);
}

std::vector<Vec3> spread_shifts(const Scene& scene, const std::vector<Placement>& members,
                                double most) {
  return Spreader(scene, members, most).run();
}

std::vector<ObjectId> lowest_first(const Scene& scene, std::vector<ObjectId> ids) {
  const auto height = [&](ObjectId id) { return scene.world_box(id).lower.z(); };
  std::stable_sort(ids.begin(), ids.end(),
                   [&](ObjectId a, ObjectId b) { return height(a) < height(b); });
  return ids;
}

}  // namespace trivet
