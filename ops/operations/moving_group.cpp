#include "ops/operations/moving_group.h"

#include <algorithm>
#include <utility>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/friction.h"
#include "ops/settle/separation.h"
#include "ops/stability/weight.h"

namespace trivet {
namespace {

constexpr int kMotionsOfGivingWay = 300;

// Fractions of the clearance that motions keep between opposite contacts without room for
// kSlideGap: the first one for which there is room. A quarter is 4 half-ulps of float32; below, the
// exact test of the exported values would refuse what was reached.
constexpr double kTightParts[] = {0.85, 0.7, 0.5, 0.35, 0.25};

// Rules for an object alone, whatever they say of those that move with it: these it may pass.
std::vector<Support> passed_by(const Scene& scene, const Object& object) {
  std::vector<Support> out;
  if (may_pass_floor(scene, object)) out.push_back(Support::floor());
  for (const ObjectId id : scene.ids())
    if (may_pass(scene, object, scene.at(id))) out.push_back(id);
  return out;
}

// Rules of single members: those of all together are too strict where a link goes with contents.
std::vector<Neighbourhood> outsides_of(const Scene& scene, const std::vector<ObjectId>& ids) {
  std::vector<Neighbourhood> out;
  if (!scene.pair_rules || ids.size() == 1) return out;
  for (const ObjectId id : ids) {
    Neighbourhood outside(scene, ids);
    outside.leave_out(passed_by(scene, scene.at(id)));
    out.push_back(std::move(outside));
  }
  return out;
}

}  // namespace

MovingGroup::MovingGroup(const Scene& scene, ObjectId object, std::span<const ObjectId> together,
                         double clearance, const SettleOptions& options, Detector* detector,
                         std::span<const ObjectId> more_loads)
    : m_scene(&scene),
      m_ids(carried_with(scene, object, together, more_loads)),
      m_driven(driven_with(scene, object, together)),
      m_outside(scene, m_ids),
      m_outside_of(outsides_of(scene, m_ids)),
      m_clearance(clearance),
      m_motion_clearance(clearance),
      m_options(options),
      m_detector(detector) {
  for (const ObjectId id : m_ids) m_origins.push_back(scene.at(id).pose);
  update();
}

void MovingGroup::update() {
  // Translations add up in one offset, so that long drags do not gather rounding.
  m_poses = m_origins;
  m_bodies.clear();
  m_contacts.assign(m_ids.size(), std::nullopt);
  for (size_t i = 0; i < m_ids.size(); ++i) {
    m_poses[i].translation += m_offset;
    m_bodies.push_back(body_of(m_scene->at(m_ids[i]), m_poses[i]));
  }
}

std::vector<Placement> MovingGroup::placements() const {
  std::vector<Placement> out;
  for (size_t i = 0; i < m_ids.size(); ++i) out.push_back({m_ids[i], m_poses[i]});
  return out;
}

Aabb MovingGroup::box() const {
  Aabb box;
  for (const Body& body : m_bodies) box.extend(body.world_box);
  return box;
}

Vec3 MovingGroup::centre() const {
  return m_bodies[0].world_from_object.apply(object().shape->mass.centre);
}

void MovingGroup::place(const Pose& pose) {
  const Pose from = m_poses[0];
  // All members turn about the first one, which goes exactly to the pose.
  const Rotation& r = from.rotation;
  const Rotation turn = (pose.rotation * Rotation{r.w, -r.x, -r.y, -r.z}).normalized();
  const Mat3 matrix = turn.matrix();
  for (size_t i = 0; i < m_ids.size(); ++i)
    m_origins[i] = {(turn * m_poses[i].rotation).normalized(),
                    Vec3(pose.translation + matrix * (m_poses[i].translation - from.translation))};
  m_origins[0] = pose;
  m_offset.setZero();
  update();
}

void MovingGroup::correct(Index member, const Pose& pose) {
  m_origins = m_poses;
  m_origins[member] = pose;
  m_offset.setZero();
  update();
}

void MovingGroup::advance(const Motion& motion, double time) {
  // A rotation rounds poses anyway, and takes the offset into them.
  if (motion.kind == Motion::Kind::Translation) {
    m_offset += time * motion.axis;
  } else {
    for (size_t i = 0; i < m_ids.size(); ++i) m_origins[i] = moved_pose(m_poses[i], motion, time);
    m_offset.setZero();
  }
  update();
}

void MovingGroup::go_back(const Place& place) {
  m_origins = place.origins;
  m_offset = place.offset;
  update();
}

bool MovingGroup::has_moved() const {
  for (size_t i = 0; i < m_ids.size(); ++i) {
    // The comparison is exact: any change of a bit counts.
    const Pose &a = m_poses[i], &b = m_scene->at(m_ids[i]).pose;
    const Rotation &p = a.rotation, &q = b.rotation;
    if (a.translation != b.translation || p.w != q.w || p.x != q.x || p.y != q.y || p.z != q.z)
      return true;
  }
  return false;
}

ObstacleContact MovingGroup::first_contact(const Motion& motion) {
  if (m_outside_of.empty()) return first_contact(m_bodies, m_outside, motion);
  ObstacleContact earliest;
  // Each member has its own obstacles: the first of all counts, of equal ones that of the first
  // member.
  for (size_t i = 0; i < m_bodies.size(); ++i) {
    ObstacleContact found = first_contact({&m_bodies[i], 1}, m_outside_of[i], motion);
    if (found.status == FirstContact::Status::Crossing) return found;
    if (found.status == FirstContact::Status::Contact && found.time < earliest.time)
      earliest = found;
  }
  return earliest;
}

ObstacleContact MovingGroup::first_contact(std::span<const Body> bodies,
                                           const Neighbourhood& others, const Motion& motion) {
  Clearance keep;
  keep.distance = m_motion_clearance;
  ObstacleContact found = trivet::first_contact(bodies, others, motion, keep, m_detector);
  ++m_num_queries;
  m_num_face_pairs += found.work.face_pairs;
  return found;
}

const std::vector<ContactsWith>& MovingGroup::contacts(Index member) const {
  std::optional<std::vector<ContactsWith>>& known = m_contacts[member];
  if (!known)
    known = touching(m_bodies[member], m_outside_of.empty() ? m_outside : m_outside_of[member],
                     m_clearance);
  return *known;
}

std::vector<GroupContact> MovingGroup::group_contacts() const {
  std::vector<GroupContact> out;
  for (Index m = 0; m < static_cast<Index>(m_bodies.size()); ++m)
    for (const ContactsWith& c : contacts(m))
      for (const ContactPoint& p : merged(c.points, kContactTolerance * m_clearance))
        out.push_back({m, c.with, p});
  return out;
}

std::optional<Vec3> MovingGroup::separating_motion_for_sliding(
    const std::vector<ContactPoint>& points, double part) const {
  // The motion has to open every gap far enough, or it is none.
  const Vec3 d = smallest_separating_motion(points, part * kSlideGap * m_clearance);
  if (!(d.norm() > 0) || d.norm() > kLargestSeparatingMotion * m_clearance) return std::nullopt;
  const bool opens_all = std::all_of(points.begin(), points.end(), [&](const ContactPoint& p) {
    return p.gap + p.normal.dot(d) >= part * kSlideBelow * m_clearance;
  });
  return opens_all ? std::optional(d) : std::nullopt;
}

bool MovingGroup::separate(const std::vector<GroupContact>& group_contacts) {
  // Usually gaps are wide enough, or can be made so.
  m_motion_clearance = m_clearance;
  std::vector<ContactPoint> points;
  points.reserve(group_contacts.size());
  for (const GroupContact& t : group_contacts) points.push_back(t.point);
  const auto is_open = [&](double part) {
    return std::all_of(points.begin(), points.end(), [&](const ContactPoint& p) {
      return p.gap >= part * kSlideBelow * m_clearance;
    });
  };
  if (is_open(1)) return false;
  std::optional<Vec3> d = separating_motion_for_sliding(points, 1);
  // Opposite contacts may leave less room: then a smaller clearance is kept for this motion.
  for (const double part : kTightParts) {
    if (d) break;
    m_motion_clearance = part * m_clearance;
    if (is_open(part)) return false;
    d = separating_motion_for_sliding(points, part);
  }
  if (!d) {
    m_motion_clearance = m_clearance;
    return false;
  }
  const double length = d->norm();
  const Motion motion = Motion::translation(*d / length, length);
  const double time = std::min(first_contact(motion).time, length);
  // A motion that is stopped at once would be repeated for ever.
  if (time < 0.1 * length) return false;
  advance(motion, time);
  return true;
}

SettleOutcome MovingGroup::settle(Interrupt* interrupt) {
  SettleProblem problem;
  problem.options = m_options;
  problem.interrupt = interrupt;
  return settle(std::move(problem), false);
}

SettleOutcome MovingGroup::give_way(Interrupt* interrupt, double longest_turn,
                                    std::int64_t max_queries) {
  // Giving way follows the materials, whatever the object itself settles by.
  SettleProblem problem;
  problem.options = m_options;
  problem.options.perfect_friction = false;
  problem.interrupt = interrupt;
  problem.max_queries = max_queries;
  const bool alone = m_ids.size() == 1;
  // A group with loads moves only once: its loads would slide on the way.
  problem.options.max_motions = alone ? std::min(m_options.max_motions, kMotionsOfGivingWay) : 0;
  if (!alone) problem.longest_turn = longest_turn;
  return settle(std::move(problem), true);
}

SettleOutcome MovingGroup::settle(SettleProblem problem, bool loads_weigh) {
  // Loads are carried shapes, with weight where they may tip the object.
  std::vector<CarriedShape> carried;
  const double weight = weight_of(object());
  for (size_t i = 1; i < m_ids.size(); ++i) {
    const Object& load = m_scene->at(m_ids[i]);
    carried.push_back({load.shape.get(), load.up, load.scale, m_poses[i], surface_of(load),
                       loads_weigh ? weight_of(load) / weight : 0});
  }
  problem.shape = object().shape.get();
  problem.up = object().up;
  problem.scale = object().scale;
  problem.surface = surface_of(object());
  problem.start = m_poses[0];
  problem.others = &m_outside;
  problem.clearance = m_clearance;
  problem.detector = m_detector;
  problem.carried = carried;
  // Contacts at the start are known from planning.
  problem.contacts_at_start = &contacts(0);
  SettleOutcome outcome = trivet::settle(problem);
  // Without a step nothing has changed, not even the offset.
  if (!outcome.steps.empty()) {
    m_origins = {outcome.pose};
    m_origins.insert(m_origins.end(), outcome.carried.begin(), outcome.carried.end());
    m_offset.setZero();
    update();
    if (outcome.status == SettleOutcome::Status::AtRest) m_contacts[0] = outcome.contacts;
  }
  m_num_queries += outcome.num_queries;
  m_num_face_pairs += outcome.num_face_pairs;
  return outcome;
}

}  // namespace trivet
