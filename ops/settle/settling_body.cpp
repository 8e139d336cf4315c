#include "ops/settle/settling_body.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/friction.h"
#include "ops/detect/detector.h"
#include "ops/settle/rest.h"
#include "ops/settle/separation.h"

namespace trivet {
namespace {

constexpr double kLeastInertia = 1e-4;  // of a mass of 1, in squares of the size

// Numbers partners for subsets.
Index number_of(const Support& with) {
  return with.is_floor() ? -1 : static_cast<Index>(with.object().index);
}

Mat3 inertia_in_world(const Shape& shape, const Body& body) {
  return inertia_per_mass(body.world_from_object.linear * shape.mass.covariance *
                          body.world_from_object.linear.transpose());
}

}  // namespace

SettlingBody::SettlingBody(const SettleProblem& problem) : m_problem(problem) {
  m_out.pose = problem.start;
  const Shape& shape = *problem.shape;
  m_object.size = problem.scale * shape.box.diagonal();
  m_object.radius_squared = problem.scale * problem.scale * shape.mass.radius_squared;
  // Carried objects move along; their weight counts if they have any.
  for (const CarriedShape& c : problem.carried) {
    m_out.carried.push_back(c.start);
    m_loads_weigh = m_loads_weigh || c.mass > 0;
  }
}

void SettlingBody::update() {
  // Answers hold at one pose only.
  m_answers.clear();
  m_bodies = {Body(*m_problem.shape, world_from_object(m_out.pose, m_problem.up, m_problem.scale))};
  for (size_t i = 0; i < m_problem.carried.size(); ++i) {
    const CarriedShape& c = m_problem.carried[i];
    m_bodies.emplace_back(*c.shape, world_from_object(m_out.carried[i], c.up, c.scale));
  }
  weigh();
}

std::vector<ContactPoint> SettlingBody::look_around() {
  update();
  assert(is_lower_than_seen());
  m_seen_height = m_object.centre.z();
  m_num_seen_steps = m_out.steps.size();
  // At the start the caller may know the contacts already.
  m_out.contacts = m_problem.contacts_at_start && m_out.steps.empty()
                       ? *m_problem.contacts_at_start
                       : contacts_with(m_bodies[0], *m_problem.others,
                                       kContactTolerance * clearance(), kFootSlack * clearance());
  return points(kContactTolerance);
}

// Energy never rises, except by the tiny translations that open gaps.
bool SettlingBody::is_lower_than_seen() const {
  if (m_out.steps.size() <= m_num_seen_steps) return true;  // unmoved, or back at a place
  // A lift may raise it by the largest opening; every other step has to lower it by at least half
  // the least drop.
  const bool lifted = m_out.steps.back().kind == SettleStep::Kind::Lift;
  const double most = lifted ? 1.001 * kLargestSeparatingMotion * clearance()
                             : -0.5 * kLastEnergyDrop * clearance();
  const double height = m_object.centre.z();
  return height <= m_seen_height + most + 1e-12 * std::max(m_object.size, std::abs(height));
}

Vec3 SettlingBody::centre_of(size_t body) const {
  const Shape& shape = body == 0 ? *m_problem.shape : *m_problem.carried[body - 1].shape;
  return m_bodies[body].world_from_object.apply(shape.mass.centre);
}

void SettlingBody::weigh() {
  m_object.centre = centre_of(0);
  // Loads without mass leave the centre and the size as they are.
  if (!m_loads_weigh) return;
  // The common centre is the mean of all, weighted by mass, where the object's own is one.
  Vec3 moment = m_object.centre;
  double mass = 1;
  Aabb box = m_bodies[0].world_box;
  for (size_t i = 1; i < m_bodies.size(); ++i) {
    moment += mass_of(i) * centre_of(i);
    mass += mass_of(i);
    box.extend(m_bodies[i].world_box);
  }
  m_object.centre = moment / mass;
  // The size stays that of the start, as tolerances depend on it.
  if (m_out.steps.empty()) m_object.size = box.diagonal();
}

Mat3 SettlingBody::inertia_per_mass() const {
  Mat3 sum = Mat3::Zero();
  double mass = 0;
  for (size_t i = 0; i < m_bodies.size(); ++i) {
    const Shape& shape = i == 0 ? *m_problem.shape : *m_problem.carried[i - 1].shape;
    // Each body's inertia is moved to the common centre (Steiner), and a little is added for
    // needles and points.
    const Vec3 arm = centre_of(i) - m_object.centre;
    sum += mass_of(i) * (inertia_in_world(shape, m_bodies[i]) +
                         arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    mass += mass_of(i);
  }
  return sum / mass + kLeastInertia * m_object.size * m_object.size * Mat3::Identity();
}

// The object's own within kContactTolerance are known.
std::vector<ContactsWith> SettlingBody::contacts_of(size_t body, double num_clearances) const {
  if (body == 0 && num_clearances == kContactTolerance) return m_out.contacts;
  return contacts_with(m_bodies[body], *m_problem.others, num_clearances * clearance(),
                       kFootSlack * clearance());
}

std::vector<ContactPoint> SettlingBody::points(double num_clearances) const {
  std::vector<ContactPoint> out;
  for (size_t i = 0; i < m_bodies.size(); ++i) {
    const auto more = all_points(contacts_of(i, num_clearances), num_clearances * clearance());
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

const Surface& SettlingBody::surface_of_body(Index body) const {
  return body == 0 ? m_problem.surface : m_problem.carried[body - 1].surface;
}

double SettlingBody::friction_with(Index body, const Support& with) const {
  return friction_share(m_problem.options) *
         friction_between(m_problem.others->scene(), surface_of_body(body), with);
}

std::vector<FrictionContact> SettlingBody::friction_points(double num_clearances) const {
  std::vector<FrictionContact> out;
  for (size_t i = 0; i < m_bodies.size(); ++i) {
    const auto more =
        friction_contacts(m_problem.others->scene(), surface_of_body(static_cast<Index>(i)),
                          contacts_of(i, num_clearances), num_clearances * clearance());
    out.insert(out.end(), more.begin(), more.end());
  }
  // Robust rest may not need all of it.
  for (FrictionContact& c : out) c.friction *= friction_share(m_problem.options);
  return out;
}

std::vector<TouchedPoint> SettlingBody::touched(double num_clearances) const {
  std::vector<TouchedPoint> out;
  for (size_t i = 0; i < m_bodies.size(); ++i)
    for (const ContactsWith& c : contacts_of(i, num_clearances))
      for (const ContactPoint& p : merged(c.points, num_clearances * clearance()))
        out.push_back({number_of(c.with), p});
  return out;
}

ObstacleContact SettlingBody::query(const Motion& motion) {
  Clearance keep;
  keep.distance = clearance();
  // A question that was asked before from here, alone or together with others, is answered already,
  // to the same bits.
  Answer* known = answer_to(motion);
  if (!known)
    known = &m_answers.emplace_back(Answer{
        motion,
        first_contact(m_bodies, *m_problem.others, motion, keep, m_problem.detector, &m_planes),
        false});
  if (std::exchange(known->early, false)) m_problem.detector->used_early();
  ObstacleContact found = known->found;
  ++m_out.num_queries;
  m_out.num_face_pairs += found.work.face_pairs;
  return found;
}

void SettlingBody::foresee(std::span<const Motion> motions) {
  // Asking together pays where a detector draws several queries at once.
  Detector* const detector = m_problem.detector;
  if (!detector || !detector->asks_together()) return;
  std::vector<Motion> unknown;
  for (const Motion& motion : motions)
    if (!answer_to(motion)) unknown.push_back(motion);
  if (unknown.size() < 2) return;
  Clearance keep;
  keep.distance = clearance();
  const auto found =
      first_contacts_early(m_bodies, *m_problem.others, unknown, keep, *detector, &m_planes);
  for (size_t i = 0; i < unknown.size(); ++i) m_answers.push_back({unknown[i], found[i], true});
}

SettlingBody::Answer* SettlingBody::answer_to(const Motion& motion) {
  for (Answer& a : m_answers)
    if (a.motion.kind == motion.kind && a.motion.axis == motion.axis &&
        a.motion.centre == motion.centre && a.motion.limit == motion.limit)
      return &a;
  return nullptr;
}

double SettlingBody::fall_limit() const {
  // The fall ends where nothing can be below any more.
  const bool floor = m_problem.others->floor();
  const double lowest = std::min(floor ? 0.0 : kInfinity, m_problem.others->box().lower.z());
  Aabb box;
  for (const Body& b : m_bodies) box.extend(b.world_box);
  const double depth = box.upper.z() - lowest;
  return std::isfinite(depth) && depth > 0 ? depth : 0;
}

double SettlingBody::sinks_by(const Motion& motion, double time) const {
  return m_object.centre.z() - moved_point(m_object.centre, motion, time).z();
}

// No longer than it takes to sink so far; nothing: it never does.
std::optional<Motion> SettlingBody::part_that_sinks(const Motion& motion, double drop) const {
  // The part is halved while it still sinks enough, so that queries stay short.
  if (sinks_by(motion, motion.limit) <= drop) return std::nullopt;
  Motion part = motion;
  while (sinks_by(motion, 0.5 * part.limit) > drop) part.limit *= 0.5;
  return part;
}

bool SettlingBody::can_sink(const Motion& motion, double drop) {
  const std::optional<Motion> part = part_that_sinks(motion, drop);
  return part && sinks_by(motion, std::min(query(*part).time, part->limit)) > drop;
}

bool SettlingBody::any_can_sink(std::span<const Candidate> candidates, double drop) {
  std::vector<Motion> parts;
  for (const Candidate& c : candidates)
    if (const auto part = part_that_sinks(c.motion, drop)) parts.push_back(*part);
  // All motions are asked together; the first that sinks decides.
  foresee(parts);
  return std::any_of(candidates.begin(), candidates.end(),
                     [&](const Candidate& c) { return can_sink(c.motion, drop); });
}

void SettlingBody::execute(SettleStep::Kind kind, const Motion& motion, double time, double drop) {
  m_answers.clear();
  m_out.pose = moved_pose(m_out.pose, motion, time);
  for (Pose& pose : m_out.carried) pose = moved_pose(pose, motion, time);
  m_out.steps.push_back({kind, m_out.pose, drop});
}

bool SettlingBody::separate_if_needed(const std::vector<ContactPoint>& points) {
  // The smallest gap decides whether there is anything to open.
  double smallest = kInfinity;
  for (const ContactPoint& c : points) smallest = std::min(smallest, c.gap);
  if (smallest >= kSeparateBelow * clearance() || m_num_separating_motions >= kMaxSeparatingMotions)
    return false;
  ++m_num_separating_motions;
  const Vec3 d = smallest_separating_motion(points, clearance());
  const double length = d.norm();
  // An opening that is too long is no rounding: other means have to move it.
  if (!(length > 0) || length > kLargestSeparatingMotion * clearance()) return false;
  const Motion motion = Motion::translation(d / length, length);
  const double time = std::min(query(motion).time, length);
  // Something else is in the way: the opening would be made again and again.
  if (time < 0.1 * length) return false;
  execute(SettleStep::Kind::Lift, motion, time, -d.z() * time / length);
  return true;
}

void SettlingBody::go_back(const Place& place) {
  m_answers.clear();
  m_out.pose = place.pose;
  m_out.carried = place.carried;
  m_out.steps.resize(place.num_steps, {});
}

SettleOutcome SettlingBody::finish(SettleOutcome::Status status) {
  m_out.status = status;
  return std::move(m_out);
}

}  // namespace trivet
