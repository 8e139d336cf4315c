#include "ops/operations/group_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ops/settle/separation.h"

namespace trivet {
namespace {

constexpr double kOnlySlides = 1e-4;   // turning, of the speed
constexpr double kRoomToTurn = 1.2;    // of what the turn takes at first
constexpr double kFarthestGap = 0.5;   // of the way of the leader
constexpr double kShortestStep = 0.1;  // clearances: a shorter translation is left out

bool has(const std::vector<Index>& members, Index body) {
  return std::find(members.begin(), members.end(), body) != members.end();
}

}  // namespace

double GroupMotion::advance(const TwistGroup& group, double duration) {
  const Twist& t = group.twist;
  // A group that hardly turns slides; otherwise its twist is a screw.
  const bool slides =
      t.turning.norm() * m_motion.bodies[group.leader].size < kOnlySlides * t.velocity.norm();
  return slides ? duration * slide(group, duration * t.velocity) : turn(group, duration);
}

// A screw is no exact motion: away from what its turn alone would press into, the turn, and back
// with the screw's translation.
double GroupMotion::turn(const TwistGroup& group, double duration) {
  const Twist& t = group.twist;
  const double rate = t.turning.norm();
  const Vec3 axis = t.turning / rate, along = t.velocity.dot(axis) * axis;
  // The turn alone goes about an axis through the point that stands still.
  const Twist turning{t.velocity - along, t.turning};
  const Vec3 leader = m_transaction.scene().at(m_ids[group.leader]).centre_of_mass();
  const Vec3 centre = leader + turning.turning.cross(turning.velocity) / (rate * rate);
  const Vec3 wanted = away_from_pressed(group, turning, duration);
  const Vec3 away = slide(group, wanted) * wanted;
  const double limit = std::min(0.5 * rate * duration, 1.0);
  const double part = execute(group, Motion::rotation(centre, axis, limit));
  // The slide along the axis covers the part that the turn has made, and the way out is undone.
  slide(group, part * duration * along - away);
  return duration * part;
}

Vec3 GroupMotion::away_from_pressed(const TwistGroup& group, const Twist& turning,
                                    double duration) const {
  std::vector<ContactPoint> pressed;  // with gaps that lack what the turn takes
  // Contacts within the group, and those of others, do not hinder it.
  for (const CoulombContact& c : m_motion.contacts) {
    const bool on = has(group.members, c.on);
    if (on == (c.from != CoulombContact::kGround && has(group.members, c.from))) continue;
    const Index other = on ? c.from : c.on;
    const Vec3 normal = on ? c.normal : Vec3(-c.normal);
    Vec3 speed = turning.at(c.point - m_motion.bodies[group.leader].centre);
    if (other != CoulombContact::kGround) speed -= m_motion.velocity(other, c.point);
    const double approach = -normal.dot(speed) * duration - c.room;
    pressed.push_back({c.point, normal, approach > 0 ? -kRoomToTurn * approach : 0,
                       ContactFeatures::ClosestPoints, 0, 0});
  }
  const Vec3 away = smallest_separating_motion(pressed, 0);
  // Making room must not be the larger part of the motion.
  const double longest = kFarthestGap * duration * m_motion.speed(group.leader);
  return away.norm() <= longest ? away : Vec3(Vec3::Zero());
}

// @return the part of the way that it gets.
double GroupMotion::slide(const TwistGroup& group, const Vec3& way) {
  const double length = way.norm();
  if (!(length > kShortestStep * m_clearance)) return 1;
  return execute(group, Motion::translation(way / length, length));
}

// @return the part of the motion that it gets.
double GroupMotion::execute(const TwistGroup& group, const Motion& motion) {
  const Scene& scene = m_transaction.scene();
  // The group moves as one body among all others as they stand now.
  std::vector<ObjectId> ids;
  std::vector<Body> bodies;
  for (const Index i : group.members) {
    ids.push_back(m_ids[i]);
    bodies.push_back(body_of(scene.at(m_ids[i])));
  }
  Clearance keep;
  keep.distance = m_clearance;
  ++m_num_queries;
  const ObstacleContact found =
      first_contact(bodies, Neighbourhood(scene, ids), motion, keep, m_run.detector);
  if (found.status == FirstContact::Status::Crossing) return 0;
  // The blocker is remembered: it may join the contacts of the next attempt.
  if (found.status == FirstContact::Status::Contact)
    m_blockers.push_back({group.members[found.moving], found.with, found.point, found.normal});
  const double time = std::min(found.time, motion.limit);
  for (const ObjectId id : ids)
    m_transaction.edit(
        id, [&](Object& object) { object.pose = moved_pose(object.pose, motion, time); });
  return time / motion.limit;
}

}  // namespace trivet
