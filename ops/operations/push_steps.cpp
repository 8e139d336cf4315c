// Walls, steps and edges on the way of a push.
#include <algorithm>
#include <cmath>

#include "ops/operations/push_axes.h"
#include "ops/operations/push_events.h"

namespace trivet {
namespace {

constexpr double kStepOn = 6;          // clearances by which a step is entered: more than gaps
constexpr double kLeastCosine = 0.02;  // of the push to a wall, for how far is stepped onto it

}  // namespace

// Length of a steep rise or drop that may still be followed; nullopt: the plan's is not steep.
std::optional<double> Push::steep_allowance(const SlidePlan& plan) {
  // The rise so far counts from where the steep part began.
  const double rise = plan.velocity.z(), z = position().z();
  if (std::abs(rise) <= kSteepRise) return std::nullopt;
  if (!m_steep) m_steep = Steep{m_group.here(), z, m_way.size()};
  const double done = rise > 0 ? z - m_steep->z : m_steep->z - z;
  return ((rise > 0 ? m_options.step_up : m_options.step_down) - done) / std::abs(rise);
}

// Back to where it began; from there it is an edge, or a wall.
Push::Next Push::give_up_steep(const SlidePlan& plan) {
  // The object goes back to where the steep part began.
  m_group.go_back(m_steep->start);
  m_way.resize(m_steep->way_length);
  m_steep.reset();
  if (plan.velocity.z() < 0) return stop(OperationResult::End::Edge);
  m_climb = false;
  // The obstacle up there is not here; the steep surface itself is.
  const size_t i = plan.blocker;
  const Obstacle steep = i < m_group_contacts.size()
                             ? Obstacle{m_group_contacts[i].point.normal,
                                        m_group_contacts[i].point.point, m_group_contacts[i].with}
                             : m_obstacles[i - m_group_contacts.size()];
  m_obstacles = {steep};
  return Next::GoOn;
}

Push::Next Push::pass_wall(const SlidePlan& blocked, const Vec3& direction, double length) {
  const Vec3 wall = m_normals[blocked.blocker];
  // Stalls end the attempts at one place.
  if (++m_num_stalls > kMaxStalls) return stop_blocked(blocked.blocker);
  // A step is climbed if it may be; if it is too high, the object slides along.
  if (m_options.step_up > 0 && climb(direction, wall, m_options.step_up)) return Next::GoOn;
  if (m_options.slide)
    if (const auto along = slide_direction(m_normals, direction, blocked.blocker, m_climb)) {
      const SlidePlan aside = slide(*along);
      // A slide that leads away from the goal is none.
      const double gain = length * along->dot(direction);
      if (gain > m_shortest && aside.kind == SlidePlan::Kind::Go) return go(aside, gain);
      if (gain > m_shortest && aside.kind == SlidePlan::Kind::NoSupport && go_down(*along))
        return Next::GoOn;
    }
  return stop_blocked(blocked.blocker);
}

// Up, a little forward, and down onto it. @return the rise; nothing: it is higher, and the object
// is where it was.
std::optional<double> Push::climb(const Vec3& direction, const Vec3& wall, double highest) {
  const Place before = m_group.here();
  const double z = position().z(), clearance = m_group.clearance();
  const auto give_up = [&]() -> std::optional<double> {
    m_group.go_back(before);
    return std::nullopt;
  };
  ObstacleContact found;
  const auto move = [&](const Vec3& way, double length) {
    const Motion motion = Motion::translation(to_world(way), length);
    found = m_group.first_contact(motion);
    if (found.status == FirstContact::Status::Crossing) return 0.0;
    const double time = std::min(found.time, length);
    m_group.advance(motion, time);
    return time;
  };
  // The object rises as high as the step may be, and a little more for clearance.
  const double up = move(Vec3::UnitZ(), highest + clearance);
  // It goes forward until it is surely over the step, more so the flatter the wall is met.
  const double cosine = std::max(kLeastCosine, -direction.dot(wall));
  const double forward = std::min(kStepOn * clearance / cosine, way_left().norm());
  if (up < clearance || move(direction, forward) < 0.9 * forward) return give_up();
  // The first thing below it, within a step's depth, is the new ground.
  const double down = up + clearance + m_options.step_down;
  if (move(-Vec3::UnitZ(), down) >= down) return give_up();
  // A ground that is too high after all is no step.
  const double rise = position().z() - z;
  if (rise > highest + 0.5 * clearance) return give_up();
  // Steep surfaces were followed before, and found to be higher: this is the same one, not its top.
  if (!m_climb && is_steep(from_world(found.normal), direction)) return give_up();
  m_planner.note_step(SettleStep::Kind::StepUp);
  note_way(false);
  if (rise > 2 * clearance) m_num_stalls = 0;
  m_obstacles.clear();
  m_steep.reset();
  return rise;
}

bool Push::go_down(const Vec3& direction) {
  const Place before = m_group.here();
  const double clearance = m_group.clearance();
  // A little way ahead is enough to leave the edge.
  const double forward = std::min(kStepOn * clearance, way_left().norm());
  const Motion over = Motion::translation(to_world(direction), forward);
  const ObstacleContact ahead = m_group.first_contact(over);
  m_group.advance(over, std::min(ahead.time, forward));
  // The drop may be as deep as a step; without ground there it is an edge.
  const Motion fall =
      Motion::translation(to_world(-Vec3::UnitZ()), m_options.step_down + clearance);
  const ObstacleContact below = m_group.first_contact(fall);
  if (below.status != FirstContact::Status::Contact) {
    m_group.go_back(before);
    return false;
  }
  m_group.advance(fall, below.time);
  m_planner.note_step(SettleStep::Kind::StepDown);
  note_way(false);
  m_obstacles = {{below.normal, below.point, below.with}};
  if (ahead.status == FirstContact::Status::Contact)
    m_obstacles.push_back({ahead.normal, ahead.point, ahead.with});
  // Standing still again and again is no progress.
  const bool stands_still = ahead.time < m_shortest && below.time < m_shortest;
  m_num_stalls = stands_still ? m_num_stalls + 1 : 0;
  return m_num_stalls <= kMaxStalls;
}

// A step is what could be climbed if it were allowed to: up to the object's own height.
Push::Next Push::stop_blocked(size_t contact) {
  const bool touch = contact < m_group_contacts.size();
  const Support with =
      touch ? m_group_contacts[contact].with : m_obstacles[contact - m_group_contacts.size()].with;
  const Vec3 point = touch ? m_group_contacts[contact].point.point
                           : m_obstacles[contact - m_group_contacts.size()].point;
  m_planner.note_blocked(with, point);
  const Vec2 left = way_left();
  const Place here = m_group.here();
  const size_t num_steps = m_planner.result().steps.size();
  const Vec3 normal = m_axes.row(2).cwiseAbs();
  const double height = 2 * m_group.bodies()[0].world_box.half_extent().dot(normal);
  // The climb is tried without limit of height, only to tell a step from a wall.
  m_climb = true;  // if it were allowed to
  if (left.norm() > m_shortest && height > m_options.step_up &&
      climb(level(left.normalized()), m_normals[contact], height)) {
    m_group.go_back(here);
    m_planner.result().steps.resize(num_steps);
    m_planner.result().end = OperationResult::End::Step;
  }
  return Next::Stop;
}

}  // namespace trivet
