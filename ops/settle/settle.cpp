#include "ops/settle/settle.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/scene.h"
#include "ops/settle/candidates.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/subsets.h"

namespace trivet {
namespace {

class Settling {
 public:
  explicit Settling(const SettleProblem& problem) : m_problem(problem) {
    m_out.pose = problem.start;
    for (const CarriedShape& c : problem.carried) m_out.carried.push_back(c.start);
    const Shape& shape = *problem.shape;
    m_object.size = problem.scale * shape.box.diagonal();
    m_object.radius_squared = problem.scale * problem.scale * shape.mass.radius_squared;
  }

  SettleOutcome run() {
    while (static_cast<int>(m_out.steps.size()) <= m_problem.options.max_motions) {
      if (m_problem.interrupt && m_problem.interrupt->reason())
        return finish(SettleOutcome::Status::Interrupted);
      const std::vector<ContactPoint> points = look_around();
      if (separate_if_needed(points)) continue;
      if (carrying_margin(points, m_object.centre) >= kRestMargin * m_object.size)
        return finish(SettleOutcome::Status::AtRest);
      if (is_rocking() && is_held(points)) return finish(SettleOutcome::Status::AtRest);
      if (may_stay(points)) return finish(SettleOutcome::Status::AtRest);
      const Candidates candidates = candidate_motions(points);
      Outcome outcome = give_way(candidates.sticking, kEnergyDrop);
      if (outcome == Outcome::Stuck) {
        const bool balanced = balance(points_to_balance());
        const std::vector<Candidate> motions =
            balanced ? carrying_motions(points) : candidates.last_resorts;
        if (balanced && (m_problem.options.literal_paper_rules || none_sinks(motions)))
          return finish(SettleOutcome::Status::AtRest);
        outcome = give_way(motions, kEnergyDrop);
        if (outcome == Outcome::Stuck) outcome = give_way(candidates.sticking, kLastEnergyDrop);
      }
      if (outcome == Outcome::FallsOut) return finish(SettleOutcome::Status::FallsOut);
      if (outcome == Outcome::Crossing) return finish(SettleOutcome::Status::Crossing);
      if (outcome == Outcome::Stuck) return finish(SettleOutcome::Status::Wedged);
    }
    return finish(SettleOutcome::Status::TooManyMotions);
  }

  bool is_at_rest() {
    const std::vector<ContactPoint> points = look_around();
    return carrying_margin(points, m_object.centre) >= kRestMargin * m_object.size ||
           is_held(points);
  }

 private:
  enum class Outcome { Moved, Stuck, FallsOut, Crossing };

  double clearance() const { return m_problem.clearance; }

  // Body, centre and contacts at the present pose.
  std::vector<ContactPoint> look_around() {
    m_bodies = {
        Body(*m_problem.shape, world_from_object(m_out.pose, m_problem.up, m_problem.scale))};
    for (size_t i = 0; i < m_problem.carried.size(); ++i) {
      const CarriedShape& c = m_problem.carried[i];
      m_bodies.emplace_back(*c.shape, world_from_object(m_out.carried[i], c.up, c.scale));
    }
    m_object.centre = m_bodies[0].world_from_object.apply(m_problem.shape->mass.centre);
    const double tolerance = kContactTolerance * clearance();
    m_out.contacts = m_problem.contacts_at_start && m_out.steps.empty()
                         ? *m_problem.contacts_at_start
                         : contacts_of(0, tolerance);
    return all_points_with(m_out.contacts, tolerance);
  }

  std::vector<ContactsWith> contacts_of(size_t body, double tolerance) const {
    return contacts_with(m_bodies[body], *m_problem.others, tolerance, kFootSlack * clearance());
  }

  // Of all bodies, when those of the object are known.
  std::vector<ContactPoint> all_points_with(const std::vector<ContactsWith>& of_object,
                                            double tolerance) const {
    std::vector<ContactPoint> points = all_points(of_object, tolerance);
    for (size_t i = 1; i < m_bodies.size(); ++i) {
      const auto more = all_points(contacts_of(i, tolerance), tolerance);
      points.insert(points.end(), more.begin(), more.end());
    }
    return points;
  }

  // Numbers partners for subsets.
  static Index number_of(const Support& with) {
    return with.is_floor() ? -1 : static_cast<Index>(with.object().index);
  }

  // Contact points of all bodies, each with the number of its partner.
  std::vector<TouchedPoint> touched(double num_clearances) const {
    const double tolerance = num_clearances * clearance();
    std::vector<TouchedPoint> out;
    for (size_t i = 0; i < m_bodies.size(); ++i)
      for (const ContactsWith& c : contacts_of(i, tolerance))
        for (const ContactPoint& p : merged(c.points, tolerance))
          out.push_back({number_of(c.with), p});
    return out;
  }

  FirstContact query(const Motion& motion) {
    Clearance keep;
    keep.distance = clearance();
    const FirstContact found =
        first_contact(m_bodies, *m_problem.others, motion, keep, m_problem.detector);
    ++m_out.num_queries;
    m_out.num_face_pairs += found.work.face_pairs;
    return found;
  }

  // Metres; 0 when nothing is below.
  double fall_limit() const {
    const bool floor = m_problem.others->floor();
    const double lowest = std::min(floor ? 0.0 : kInfinity, m_problem.others->box().lower.z());
    Aabb box;
    for (const Body& b : m_bodies) box.extend(b.world_box);
    const double depth = box.upper.z() - lowest;
    return std::isfinite(depth) && depth > 0 ? depth : 0;
  }

  // A load is no pivot.
  static bool may_be_pivot(const ContactPoint& c) { return c.normal.z() >= -kSupportNormalZ; }

  std::vector<Candidate> carrying_motions(std::vector<ContactPoint> points) const {
    std::erase_if(points, [](const ContactPoint& c) { return !may_be_pivot(c); });
    return gauss_candidates(points, m_object, fall_limit()).sticking;
  }

  // An object that hovers turns about what is below.
  bool none_sinks_about(const std::vector<ContactPoint>& close,
                        const std::vector<ContactPoint>& near) {
    return none_sinks(carrying_motions(close.empty() ? near : close));
  }

  // Whether what it touches, or some of it, balances the object and gives no turn that lowers it.
  bool is_held(const std::vector<ContactPoint>& points) {
    const std::vector<ContactPoint> near = points_to_balance();
    return balance(near) && (none_sinks_about(points, near) || is_held_by_some());
  }

  // Whether gaps were opened again and again, which an object thinner than the contacts' tolerance
  // goes on with.
  bool is_rocking() const { return m_num_separating_motions > kLiftsOfRocking; }

  // At the start: whether it is held, although some turn would lower it by more than closing a gap.
  // Contacts that are merely near do not count: the turn would close these.
  bool may_stay(const std::vector<ContactPoint>& points) {
    if (m_sank || points.empty() || m_problem.options.literal_paper_rules) return false;
    return balance(points) && !none_sinks(candidate_motions(points).sticking) && is_held(points);
  }

  // Rest must not end because of one more contact: bodies that give pivots are left out in turn. As
  // obstacles they stay.
  bool is_held_by_some() {
    const std::vector<TouchedPoint> close = touched(kContactTolerance),
                                    near = touched(kBalanceTolerance);
    std::vector<Index> bodies;
    for (const TouchedPoint& t : close)
      if (may_be_pivot(t.point)) bodies.push_back(t.fixed);
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    return holds_without_some(bodies, [&](const std::vector<Index>& left_out) {
      const std::vector<ContactPoint> carrying = points_without(near, left_out);
      if (!balance(carrying)) return Hold::Never;
      return none_sinks_about(points_without(close, left_out), carrying) ? Hold::Yes : Hold::No;
    });
  }

  // By more than the contacts' tolerance.
  bool none_sinks(const std::vector<Candidate>& motions) {
    const double tolerance = kBalanceTolerance * clearance();
    return std::none_of(motions.begin(), motions.end(), [&](const Candidate& c) {
      const double time = std::min(query(c.motion).time, c.motion.limit);
      return sinks_by(c.motion, time) > tolerance;
    });
  }

  double sinks_by(const Motion& motion, double time) const {
    return m_object.centre.z() - moved_point(m_object.centre, motion, time).z();
  }

  void execute(SettleStep::Kind kind, const Motion& motion, double time, double drop) {
    m_out.pose = moved_pose(m_out.pose, motion, time);
    for (Pose& pose : m_out.carried) pose = moved_pose(pose, motion, time);
    m_out.steps.push_back({kind, m_out.pose, drop});
    m_sank = m_sank || kind != SettleStep::Kind::Lift;
  }

  Candidates candidate_motions(const std::vector<ContactPoint>& points) const {
    return m_problem.options.literal_paper_rules ? paper_candidates(points, m_object, fall_limit())
                                                 : gauss_candidates(points, m_object, fall_limit());
  }

  // Executes the first candidate that lowers the centre of mass by `least` clearances.
  Outcome give_way(const std::vector<Candidate>& candidates, double least) {
    for (const Candidate& c : candidates) {
      const FirstContact found = query(c.motion);
      if (found.status == FirstContact::Status::Crossing && m_out.steps.empty())
        return Outcome::Crossing;
      if (c.kind == SettleStep::Kind::Fall && found.status == FirstContact::Status::Free)
        return Outcome::FallsOut;
      const double time = std::min(found.time, c.motion.limit);
      const double drop = sinks_by(c.motion, time);
      if (drop < least * clearance()) continue;
      execute(c.kind, c.motion, time, drop);
      return Outcome::Moved;
    }
    return Outcome::Stuck;
  }

  // Gaps that shrank below half the clearance are opened again, by the smallest translation.
  bool separate_if_needed(const std::vector<ContactPoint>& points) {
    double smallest = kInfinity;
    for (const ContactPoint& c : points) smallest = std::min(smallest, c.gap);
    if (smallest >= kSeparateBelow * clearance() ||
        m_num_separating_motions >= kMaxSeparatingMotions)
      return false;
    ++m_num_separating_motions;
    const Vec3 d = smallest_separating_motion(points, clearance());
    const double length = d.norm();
    if (!(length > 0) || length > kLargestSeparatingMotion * clearance()) return false;
    const Motion motion = Motion::translation(d / length, length);
    const double time = std::min(query(motion).time, length);
    if (time < 0.1 * length) return false;
    execute(SettleStep::Kind::Lift, motion, time, -d.z() * time / length);
    return true;
  }

  // Contacts that a last closing motion, too short to be executed, would close count as well.
  std::vector<ContactPoint> points_to_balance() const {
    const double tolerance = kBalanceTolerance * clearance();
    return all_points_with(contacts_of(0, tolerance), tolerance);
  }

  bool balance(const std::vector<ContactPoint>& near) const {
    const bool touches = std::any_of(near.begin(), near.end(), [&](const ContactPoint& c) {
      return c.gap <= kHoverTolerance * clearance();
    });
    return touches && trivet::is_balanced(near, m_object.centre, m_object.size, clearance());
  }

  SettleOutcome finish(SettleOutcome::Status status) {
    m_out.status = status;
    return std::move(m_out);
  }

  const SettleProblem& m_problem;
  SettleOutcome m_out;
  SettlingObject m_object;
  std::vector<Body> m_bodies;  // the object, then what it carries
  int m_num_separating_motions = 0;
  bool m_sank = false;
};

}  // namespace

Vec3 smallest_separating_motion(const std::vector<ContactPoint>& points, double clearance) {
  std::vector<double> weights(points.size(), 0.0);
  Vec3 d = Vec3::Zero();
  for (int sweep = 0; sweep < kLiftSweeps; ++sweep)
    for (size_t i = 0; i < points.size(); ++i) {
      const double missing = clearance - points[i].gap - points[i].normal.dot(d);
      const double change = std::max(-weights[i], missing);
      weights[i] += change;
      d += change * points[i].normal;
    }
  return d;
}

bool is_balanced(const std::vector<ContactPoint>& contacts, const Vec3& centre, double size,
                 double clearance) {
  if (carrying_margin(contacts, centre) >= kRestMargin * size) return true;
  const double enough = residual_tolerance(size, clearance);
  return equilibrium_residual(contacts, centre, size, kLargestFriction, enough) <= enough;
}

bool is_at_rest(const SettleProblem& problem) { return Settling(problem).is_at_rest(); }

double residual_tolerance(double size, double clearance) {
  return std::min(1e-2, 1e-7 + kBalanceTolerance * clearance / std::max(size, clearance));
}

SettleOutcome settle(const SettleProblem& problem) { return Settling(problem).run(); }

}  // namespace trivet
