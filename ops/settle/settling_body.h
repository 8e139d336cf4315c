// The object that settles, with what it carries: where it is, what it touches, how it moves.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ops/settle/candidates.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/settle_problem.h"
#include "ops/settle/subsets.h"

namespace trivet {

/// Works on copies of poses. Refers to its problem.
class SettlingBody {
 public:
  explicit SettlingBody(const SettleProblem& problem);

  /// Bodies, centre and contacts at the present pose, which all below means until the next motion.
  /// @return contacts of all bodies.
  std::vector<ContactPoint> look_around();
  /// Bodies and centre alone, after a motion: its contacts are unknown then.
  void update();
  /// Centre of mass, size; with loads that weigh, of all together.
  const SettlingObject& object() const { return m_object; }
  /// Inertia for a mass of 1, about the centre; a little is added, so that lines and points have
  /// some.
  Mat3 inertia_per_mass() const;
  /// Contacts of all bodies within `num_clearances`; those at one place are one.
  std::vector<ContactPoint> points(double num_clearances) const;
  std::vector<FrictionContact> friction_points(double num_clearances) const;
  /// The same, each with the number of its partner.
  std::vector<TouchedPoint> touched(double num_clearances) const;

  /// Coulomb's coefficient of a body against something outside.
  double friction_with(Index body, const Support& with) const;

  ObstacleContact query(const Motion& motion);
  /// Where a GPU answers: asks about these motions together; query() then knows the answers until
  /// the body moves.
  void foresee(std::span<const Motion> motions);
  /// Metres that it may fall before it is below everything; 0 when nothing is below.
  double fall_limit() const;
  double sinks_by(const Motion& motion, double time) const;
  /// True if a motion to where the centre is lowest sinks by more than `drop` before its first
  /// contact. Looks no farther than that takes.
  bool can_sink(const Motion& motion, double drop);
  bool any_can_sink(std::span<const Candidate> candidates, double drop);
  void execute(SettleStep::Kind kind, const Motion& motion, double time, double drop);
  /// Opens gaps that shrank below half the clearance, by the smallest translation.
  /// @return whether it has moved.
  bool separate_if_needed(const std::vector<ContactPoint>& points);
  int num_separating_motions() const { return m_num_separating_motions; }

  /// A place to come back to.
  struct Place {
    Pose pose;
    std::vector<Pose> carried;
    size_t num_steps = 0;
  };
  Place here() const { return {m_out.pose, m_out.carried, m_out.steps.size()}; }
  void go_back(const Place& place);

  double clearance() const { return m_problem.clearance; }
  const SettleOutcome& outcome() const { return m_out; }
  SettleOutcome finish(SettleOutcome::Status status);

 private:
  struct Answer {
    Motion motion;
    ObstacleContact found;
    bool early;  // asked by foresee(), and not used yet
  };

  std::optional<Motion> part_that_sinks(const Motion& motion, double drop) const;
  Answer* answer_to(const Motion& motion);  // null: not asked from here
  std::vector<ContactsWith> contacts_of(size_t body, double num_clearances) const;
  bool is_lower_than_seen() const;
  const Surface& surface_of_body(Index body) const;
  double mass_of(size_t body) const { return body == 0 ? 1 : m_problem.carried[body - 1].mass; }
  Vec3 centre_of(size_t body) const;
  void weigh();

  const SettleProblem& m_problem;
  SeparatingPlanes m_planes;  // every motion meets faces of the one before
  SettleOutcome m_out;
  SettlingObject m_object;
  std::vector<Body> m_bodies;     // the object, then what it carries
  std::vector<Answer> m_answers;  // from here
  bool m_loads_weigh = false;
  int m_num_separating_motions = 0;
  // When it last looked around: the height of its centre, and the number of its steps.
  double m_seen_height = 0;
  size_t m_num_seen_steps = 0;
};

}  // namespace trivet
