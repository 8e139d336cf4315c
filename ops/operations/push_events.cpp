#include "ops/operations/push_events.h"

#include <algorithm>
#include <cmath>

#include "core/base/tunables.h"
#include "ops/operations/contact_end.h"
#include "ops/operations/push_axes.h"
#include "ops/settle/equilibrium.h"

namespace trivet {
namespace {

constexpr double kShortestPush = 0.5;  // clearances
constexpr double kUnknownEnd = 100;    // clearances until obstacles are looked at again

}  // namespace

Push::Push(MovePlanner& planner, const PushOperation& o)
    : m_planner(planner),
      m_group(planner.group()),
      m_options(o),
      m_is_level(is_level(o.normal)),
      m_axes(push_axes(o.normal)),
      m_shortest(kShortestPush * planner.group().clearance()) {
  find_contacts();
  note_way(false);
  // An object that nothing carries has no surface to slide on.
  const bool carried = std::any_of(m_group_contacts.begin(), m_group_contacts.end(),
                                   [&](const GroupContact& t) { return carries(t.point); }) ||
                       is_known_to_lie();
  if (!carried) m_planner.refuse({Refusal::Cause::NothingToSlideOn, {m_planner.name()}});
}

bool Push::carries(const ContactPoint& p) const {
  return from_world(p.normal).z() > kSupportNormalZ;
}

// The object may have come to rest on it across a gap, or with a clearance a little larger: the
// push first goes down onto it.
bool Push::is_known_to_lie() const {
  const std::vector<ObjectContact>& links = m_group.object().contacts;
  return std::any_of(links.begin(), links.end(), [&](const ObjectContact& entry) {
    const std::vector<ContactPoint>& points = entry.contact.points;
    return std::any_of(points.begin(), points.end(),
                       [&](const ContactPoint& p) { return carries(p); });
  });
}

// Contacts are looked for again only where the group has moved.
void Push::find_contacts() {
  const Vec3 offset = m_group.here().offset;
  if (m_found_at != offset) m_group_contacts = m_group.group_contacts(), m_found_at = offset;
  m_normals.clear();
  for (const GroupContact& t : m_group_contacts) m_normals.push_back(from_world(t.point.normal));
  for (const Obstacle& o : m_obstacles) m_normals.push_back(from_world(o.normal));
}

Vec2 Push::way_left() const { return m_goal - Vec2(position().head<2>()); }

void Push::push_to(const Vec2& goal) {
  m_goal = goal;
  m_num_stalls = 0;
  m_climb = true;
  m_planner.result().end = OperationResult::End::Reached;
  // The number of events is bounded, as a path may go round in circles.
  const auto max_events =
      m_planner.result().steps.size() + static_cast<size_t>(m_planner.options().max_motions);
  // Each event plans anew from the contacts of the place.
  while (event() == Next::GoOn) {
    if (m_planner.refused() || m_planner.interrupted()) return;
    if (m_planner.result().steps.size() > max_events)
      return m_planner.refuse({Refusal::Cause::PathTooLong,
                               {m_planner.name()},
                               {{"max_motions", double(m_planner.options().max_motions)}}});
  }
}

Push::Next Push::event() {
  const Vec2 left = way_left();
  const double length = left.norm();
  if (length <= m_shortest) return stop(OperationResult::End::Reached);
  find_contacts();
  // The contacts stay the same but for their gaps.
  if (!m_is_separated && m_group.separate(m_group_contacts)) m_found_at = m_group.here().offset;
  m_is_separated = true;
  const Vec3 direction = level(left / length);
  // The plan of the slide tells the event: on, a wall, or an edge.
  const SlidePlan way = slide(direction);
  switch (way.kind) {
    case SlidePlan::Kind::Go:
      return go(way, length);
    case SlidePlan::Kind::Blocked:
      return pass_wall(way, direction, length);
    case SlidePlan::Kind::NoSupport:
      break;
  }
  return go_down(direction) ? Next::GoOn : stop(OperationResult::End::Edge);
}

SlidePlan Push::slide(const Vec3& direction) const {
  return plan_slide(
      m_normals, direction, [&](size_t i, const Vec3& velocity) { return end_of(i, velocity); },
      m_shortest, m_climb);
}

double Push::end_of(size_t contact, const Vec3& velocity) const {
  // Obstacles have no known end, and are looked at again after a little way.
  if (contact >= m_group_contacts.size()) return kUnknownEnd * m_group.clearance();
  const GroupContact& t = m_group_contacts[contact];
  std::optional<Body> fixed;
  if (t.with.is_object()) fixed = body_of(m_group.scene().at(t.with.object()));
  return contact_end(m_group.bodies()[t.member], fixed ? &*fixed : nullptr, t.point,
                     to_world(velocity), kContactTolerance * m_group.clearance());
}

// --- going on --------------------------------------------------------------------------------

Push::Next Push::go(const SlidePlan& plan, double length) {
  // The slide ends at the goal, at the end of a contact, or where a steep part gets too high.
  double way = std::min(length, plan.lasts);
  const std::optional<double> allowance = steep_allowance(plan);
  if (allowance) {
    if (*allowance <= m_shortest) return give_up_steep(plan);
    way = std::min(way, *allowance);
  }
  // The speed is that along the surface; `way` is level.
  const double speed = plan.velocity.norm();
  const Motion motion = Motion::translation(to_world(plan.velocity / speed), way * speed);
  const ObstacleContact found = m_group.first_contact(motion);
  if (found.status == FirstContact::Status::Crossing) {
    m_planner.refuse(
        {Refusal::Cause::AlreadyTouches, {m_planner.name(), named(m_group.scene(), found.with)}});
    return Next::Stop;
  }
  const double time = std::min(found.time, motion.limit);
  const bool gets_on = time > m_shortest;
  // Progress forgets old obstacles and stalls.
  if (gets_on) {
    m_group.advance(motion, time);
    m_planner.note_step(SettleStep::Kind::Slide);
    note_way(true);
    m_obstacles.clear();
    m_num_stalls = 0;
    if (!allowance) m_steep.reset(), m_climb = true;
  }
  // The obstacle ahead becomes a contact of the next plan.
  if (found.status == FirstContact::Status::Contact)
    m_obstacles.push_back({found.normal, found.point, found.with});
  // A slide that gets nowhere again and again is blocked.
  if (!gets_on && ++m_num_stalls > kMaxStalls) {
    m_planner.note_blocked(found.with, found.point);
    return Next::Stop;
  }
  return Next::GoOn;
}

// --- the end ---------------------------------------------------------------------------------

Push::Next Push::stop(OperationResult::End end) {
  m_planner.result().end = end;
  return Next::Stop;
}

void Push::note_way(bool straight) {
  m_way.push_back({m_group.here().offset, straight});
  m_is_separated = false;
}

// Lets the object go there. @return how it settled; nothing: it sinks deeper than a step, or
// does not come to rest.
std::optional<SettleOutcome> Push::settled_from(const Vec3& offset) {
  Place place = m_group.here();
  place.offset = offset;
  m_group.go_back(place);
  const double z = m_group.centre().z();
  SettleOutcome outcome = m_planner.settle();
  const double sinks = z - m_group.centre().z();
  // An object that sinks deeper than a step has left the surface.
  if (outcome.status != SettleOutcome::Status::AtRest ||
      sinks > m_options.step_down + m_group.clearance())
    return std::nullopt;
  return outcome;
}

bool Push::holds_at(const Vec3& offset) {
  const Place here = m_group.here();
  const bool holds = settled_from(offset).has_value();
  m_group.go_back(here);
  return holds;
}

// The last place on the way from where it holds, if it does so at the start.
std::optional<Vec3> Push::last_place_that_holds() {
  // The way is searched by halving: it holds at its start and not at its end.
  if (m_way.size() < 2 || !holds_at(m_way[0].offset)) return std::nullopt;
  size_t good = 0, bad = m_way.size() - 1;
  while (bad - good > 1 && !m_planner.interrupted()) {
    const size_t middle = (good + bad) / 2;
    (holds_at(m_way[middle].offset) ? good : bad) = middle;
  }
  // Within a straight stretch the halving goes on to the last place itself.
  Vec3 last = m_way[good].offset, beyond = m_way[bad].offset;
  while (m_way[bad].straight && (beyond - last).norm() > 2 * m_shortest &&
         !m_planner.interrupted()) {
    const Vec3 middle = 0.5 * (last + beyond);
    (holds_at(middle) ? last : beyond) = middle;
  }
  return last;
}

// From the last place on the way where the object does not sink deeper than a step; if there is
// none, from where it is.
void Push::release() {
  if (!m_is_level) return m_planner.release();
  find_contacts();
  // An object that stands on the surface by its contacts needs no search.
  std::vector<ContactPoint> points;
  for (const GroupContact& t : m_group_contacts)
    if (t.member == 0) points.push_back(t.point);
  const bool stands = carrying_margin(points, m_group.centre()) >= kRestMargin * m_group.size();
  if (m_planner.is_joint() || (stands && !has_finite_friction(m_planner.options())))
    return m_planner.release();  // it stands there
  Place end = m_group.here();
  // An object without that settles from where it is, or from the last place that holds.
  if (const auto outcome = settled_from(end.offset)) return m_planner.end_settled(*outcome);
  m_group.go_back(end);
  if (const std::optional<Vec3> last = last_place_that_holds()) {
    end.offset = *last;
    m_group.go_back(end);
    m_planner.note_step(SettleStep::Kind::Slide);
    m_planner.result().end = OperationResult::End::Edge;
  }
  if (!m_planner.interrupted()) m_planner.release();
}

MovePlan Push::finish() {
  if (m_options.settle && !m_planner.refused() && m_group.has_moved()) release();
  return m_planner.finish(ObjectState::Held);
}

}  // namespace trivet
