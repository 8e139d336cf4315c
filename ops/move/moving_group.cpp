#include "ops/move/moving_group.h"

#include <algorithm>

#include "core/base/quoted.h"
#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "ops/detect/detector.h"

namespace trivet {
namespace {

// Where opposite contacts leave no room for kSlideGap, motions keep the first of these parts of the
// clearance for which there is room. A quarter is 4 half-ulps of float32; below, the exact test of
// the exported values would refuse what was reached.
constexpr double kTightParts[] = {0.85, 0.7, 0.5, 0.35, 0.25};

bool has(const std::vector<ObjectId>& ids, ObjectId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

void append_loads(const Scene& scene, ObjectId id, std::vector<ObjectId>& ids) {
  for (const Link& link : scene.at(id).links)
    if (link.with && weighs_on(link.contact) && !scene.at(*link.with).fixed &&
        !has(ids, *link.with))
      ids.push_back(*link.with);
}

void append_mates(const Scene& scene, ObjectId id, std::vector<ObjectId>& ids) {
  const std::string& group = scene.at(id).group;
  if (group.empty()) return;
  for (const ObjectId other : scene.ids())
    if (scene.at(other).placed && scene.at(other).group == group && !has(ids, other))
      ids.push_back(other);
}

void append_all(std::span<const ObjectId> more, std::vector<ObjectId>& ids) {
  for (const ObjectId id : more)
    if (!has(ids, id)) ids.push_back(id);
}

}  // namespace

std::vector<ObjectId> led_with(const Scene& scene, ObjectId object,
                               std::span<const ObjectId> together) {
  std::vector<ObjectId> ids{object};
  append_all(together, ids);
  for (size_t i = 0; i < ids.size(); ++i) append_mates(scene, ids[i], ids);
  return ids;
}

std::vector<ObjectId> carried_with(const Scene& scene, ObjectId object,
                                   std::span<const ObjectId> together) {
  std::vector<ObjectId> ids{object};
  if (!scene.at(object).placed) return ids;
  append_all(together, ids);
  for (size_t i = 0; i < ids.size(); ++i) {
    append_loads(scene, ids[i], ids);
    append_mates(scene, ids[i], ids);
  }
  std::sort(ids.begin() + 1, ids.end(), [](ObjectId a, ObjectId b) { return a.index < b.index; });
  return ids;
}

std::string why_not_movable(const Scene& scene, std::span<const ObjectId> ids) {
  for (const ObjectId id : ids) {
    const Object& object = scene.at(id);
    if (!object.fixed && !object.locked) continue;
    const char* const how = object.fixed ? "fixed" : "locked";
    const std::string along = id == ids[0] ? "" : " and would have to move along";
    return quoted(object.name) + " is " + how + along + (object.fixed ? ": unfix" : ": unlock") +
           " it first";
  }
  return "";
}

MovingGroup::MovingGroup(const Scene& scene, ObjectId object, std::span<const ObjectId> together,
                         double clearance, const SettleOptions& options)
    : m_scene(&scene),
      m_ids(carried_with(scene, object, together)),
      m_led(led_with(scene, object, together)),
      m_outside(scene, m_ids),
      m_clearance(clearance),
      m_motion_clearance(clearance),
      m_options(options) {
  for (const ObjectId id : m_ids) m_origins.push_back(scene.at(id).pose);
  update();
}

void MovingGroup::update() {
  m_poses = m_origins;
  m_bodies.clear();
  m_contacts.assign(m_ids.size(), std::nullopt);
  for (size_t i = 0; i < m_ids.size(); ++i) {
    m_poses[i].translation += m_offset;
    const Object& object = m_scene->at(m_ids[i]);
    m_bodies.emplace_back(*object.shape, world_from_object(m_poses[i], object.up, object.scale));
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

double MovingGroup::size() const { return object().scale * object().shape->box.diagonal(); }

void MovingGroup::place(const Pose& pose) {
  const Pose from = m_poses[0];
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

void MovingGroup::advance(const Motion& motion, double time) {
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
    const Pose &a = m_poses[i], &b = m_scene->at(m_ids[i]).pose;
    const Rotation &p = a.rotation, &q = b.rotation;
    if (a.translation != b.translation || p.w != q.w || p.x != q.x || p.y != q.y || p.z != q.z)
      return true;
  }
  return false;
}

FirstContact MovingGroup::first_contact(const Motion& motion) {
  FirstContactQuery query;
  query.clearance.distance = m_motion_clearance;
  query.moving = m_bodies;
  query.fixed = m_outside.bodies;
  query.floor = m_scene->floor;
  query.motion = motion;
  const FirstContact found = trivet::first_contact(query, m_options.detector);
  ++m_num_queries;
  m_num_face_pairs += found.work.face_pairs;
  return found;
}

const std::vector<ContactsWith>& MovingGroup::contacts(Index member) const {
  std::optional<std::vector<ContactsWith>>& known = m_contacts[member];
  if (!known)
    known = contacts_with(m_bodies[member], m_outside.bodies, m_scene->floor,
                          kContactTolerance * m_clearance, kFootSlack * m_clearance);
  return *known;
}

std::vector<Touch> MovingGroup::touches() const {
  std::vector<Touch> out;
  for (Index m = 0; m < static_cast<Index>(m_bodies.size()); ++m)
    for (const ContactsWith& c : contacts(m))
      for (const ContactPoint& p : merged(c.points, kContactTolerance * m_clearance))
        out.push_back({m, c.fixed, p});
  return out;
}

std::optional<Vec3> MovingGroup::lift_for_sliding(const std::vector<ContactPoint>& points,
                                                  double part) const {
  const Vec3 d = smallest_lift(points, part * kSlideGap * m_clearance);
  if (!(d.norm() > 0) || d.norm() > kLargestLift * m_clearance) return std::nullopt;
  const bool opens_all = std::all_of(points.begin(), points.end(), [&](const ContactPoint& p) {
    return p.gap + p.normal.dot(d) >= part * kSlideBelow * m_clearance;
  });
  return opens_all ? std::optional(d) : std::nullopt;
}

bool MovingGroup::float_off(const std::vector<Touch>& touches) {
  m_motion_clearance = m_clearance;
  std::vector<ContactPoint> points;
  for (const Touch& t : touches) points.push_back(t.point);
  const auto is_open = [&](double part) {
    return std::all_of(points.begin(), points.end(), [&](const ContactPoint& p) {
      return p.gap >= part * kSlideBelow * m_clearance;
    });
  };
  if (is_open(1)) return false;
  std::optional<Vec3> d = lift_for_sliding(points, 1);
  for (const double part : kTightParts) {
    if (d) break;
    m_motion_clearance = part * m_clearance;
    if (is_open(part)) return false;
    d = lift_for_sliding(points, part);
  }
  if (!d) {
    m_motion_clearance = m_clearance;
    return false;
  }
  const double length = d->norm();
  const Motion motion = Motion::translation(*d / length, length);
  const double time = std::min(first_contact(motion).time, length);
  if (time < 0.1 * length) return false;
  advance(motion, time);
  return true;
}

SettleOutcome MovingGroup::settle(Interrupt* interrupt) {
  std::vector<CarriedShape> carried;
  for (size_t i = 1; i < m_ids.size(); ++i) {
    const Object& load = m_scene->at(m_ids[i]);
    carried.push_back({load.shape.get(), load.up, load.scale, m_poses[i]});
  }
  const SettleProblem problem{
      object().shape.get(), object().up, object().scale, m_poses[0], m_outside.bodies,
      m_scene->floor,       m_clearance, m_options,      interrupt,  carried,
      &contacts(0)};
  SettleOutcome outcome = trivet::settle(problem);
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
