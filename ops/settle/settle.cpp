#include "ops/settle/settle.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/scene.h"
#include "ops/settle/candidates.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/friction_settling.h"
#include "ops/settle/settling_body.h"
#include "ops/settle/subsets.h"

namespace trivet {
namespace {

class Settling {
 public:
  explicit Settling(const SettleProblem& problem) : m_problem(problem), m_body(problem) {}

  SettleOutcome run() {
    while (static_cast<int>(m_body.outcome().steps.size()) <= m_problem.options.max_motions) {
      if (m_problem.interrupt && m_problem.interrupt->reason())
        return m_body.finish(SettleOutcome::Status::Interrupted);
      const std::vector<ContactPoint> points = m_body.look_around();
      // Gaps that became too small are opened first, as motions need room to begin.
      if (m_body.separate_if_needed(points)) continue;
      // The centre above the support polygon is rest, by the paper's rule.
      if (carrying_margin(points, object().centre) >= kRestMargin * object().size)
        return m_body.finish(SettleOutcome::Status::AtRest);
      if (is_rocking() && is_held(points)) return m_body.finish(SettleOutcome::Status::AtRest);
      if (may_stay(points)) return m_body.finish(SettleOutcome::Status::AtRest);
      // Motions that keep what they touch are tried in the order of Gauss' principle.
      const std::vector<Candidate> sticking = candidate_motions(points);
      Outcome outcome = give_way(sticking, kEnergyDrop);
      // No turn that keeps its contacts lowers the object: forces balance it, or something more has
      // to be tried.
      if (outcome == Outcome::Stuck) {
        const bool balanced = balance(m_body.points(kBalanceTolerance));
        // A balanced object may still turn about a contact that carries; one that is not balanced
        // may part from all.
        const std::vector<Candidate> motions =
            balanced ? carrying_motions(points) : last_motions(points);
        if (balanced && (m_problem.options.literal_paper_rules || none_sinks(motions)))
          return m_body.finish(SettleOutcome::Status::AtRest);
        outcome = give_way(motions, kEnergyDrop);
        // Very short drops are the last resort before it counts as wedged.
        if (outcome == Outcome::Stuck) outcome = give_way(sticking, kLastEnergyDrop);
      }
      if (outcome == Outcome::FallsOut) return m_body.finish(SettleOutcome::Status::FallsOut);
      if (outcome == Outcome::Crossing) return m_body.finish(SettleOutcome::Status::Crossing);
      if (outcome == Outcome::Stuck) return m_body.finish(SettleOutcome::Status::Wedged);
    }
    return m_body.finish(SettleOutcome::Status::TooManyMotions);
  }

  bool is_at_rest() {
    const std::vector<ContactPoint> points = m_body.look_around();
    return carrying_margin(points, object().centre) >= kRestMargin * object().size ||
           is_held(points);
  }

 private:
  enum class Outcome { Moved, Stuck, FallsOut, Crossing };

  const SettlingObject& object() const { return m_body.object(); }
  double clearance() const { return m_body.clearance(); }

  // A load is no pivot.
  static bool may_be_pivot(const ContactPoint& c) { return c.normal.z() >= -kSupportNormalZ; }

  std::vector<Candidate> carrying_motions(std::vector<ContactPoint> points) const {
    std::erase_if(points, [](const ContactPoint& c) { return !may_be_pivot(c); });
    return gauss_candidates(points, object(), m_body.fall_limit());
  }

  // An object that hovers turns about what is below.
  bool none_sinks_about(const std::vector<ContactPoint>& close,
                        const std::vector<ContactPoint>& near) {
    return none_sinks(carrying_motions(close.empty() ? near : close));
  }

  // True if all contacts, or some of them, balance the object and no turn about them lowers it.
  bool is_held(const std::vector<ContactPoint>& points) {
    const std::vector<ContactPoint> near = m_body.points(kBalanceTolerance);
    return balance(near) && (none_sinks_about(points, near) || is_held_by_some());
  }

  // True if gaps were opened again and again: an object thinner than the contacts' tolerance never
  // stops doing that.
  bool is_rocking() const { return m_body.num_separating_motions() > kLiftsOfRocking; }

  // At the start: whether it is held, although some turn would lower it by more than closing a gap.
  // Contacts that are merely near do not count: the turn would close these.
  bool may_stay(const std::vector<ContactPoint>& points) {
    if (m_sank || points.empty() || m_problem.options.literal_paper_rules) return false;
    return balance(points) && !none_sinks(candidate_motions(points)) && is_held(points);
  }

  // Rest must not end because of one more contact: bodies that give pivots are left out in turn. As
  // obstacles they stay.
  bool is_held_by_some() {
    // Contacts are collected once; each choice takes points away from them.
    const std::vector<TouchedPoint> close = m_body.touched(kContactTolerance),
                                    near = m_body.touched(kBalanceTolerance);
    std::vector<Index> bodies;
    for (const TouchedPoint& t : close)
      if (may_be_pivot(t.point)) bodies.push_back(t.fixed);
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    return holds_without_some(bodies, [&](const std::vector<Index>& left_out) {
      const std::vector<ContactPoint> carrying = points_without(near, left_out);
      // Fewer contacts cannot balance what more do not: no subset of these is asked.
      if (!balance(carrying)) return Hold::Never;
      return none_sinks_about(points_without(close, left_out), carrying) ? Hold::Yes : Hold::No;
    });
  }

  // By more than the contacts' tolerance.
  bool none_sinks(const std::vector<Candidate>& motions) {
    return !m_body.any_can_sink(motions, kBalanceTolerance * clearance());
  }

  std::vector<Candidate> candidate_motions(const std::vector<ContactPoint>& points) const {
    return m_problem.options.literal_paper_rules
               ? paper_candidates(points, object(), m_body.fall_limit())
               : gauss_candidates(points, object(), m_body.fall_limit());
  }

  std::vector<Candidate> last_motions(const std::vector<ContactPoint>& points) const {
    if (m_problem.options.literal_paper_rules) return {};
    return last_resorts(points, object());
  }

  // Most often the first one moves it: the others are asked about, together, when it does not.
  void foresee_after_first(const std::vector<Candidate>& candidates) {
    std::vector<Motion> motions;
    for (size_t i = 1; i < candidates.size(); ++i) motions.push_back(candidates[i].motion);
    m_body.foresee(motions);
  }

  // Executes the first candidate that lowers the centre of mass by `least` clearances.
  Outcome give_way(const std::vector<Candidate>& candidates, double least) {
    for (size_t i = 0; i < candidates.size(); ++i) {
      if (i == 1) foresee_after_first(candidates);
      const Candidate& c = candidates[i];
      const FirstContact found = m_body.query(c.motion);
      // Objects that overlap from the start can be moved by nothing.
      if (found.status == FirstContact::Status::Crossing && m_body.outcome().steps.empty())
        return Outcome::Crossing;
      if (c.kind == SettleStep::Kind::Fall && found.status == FirstContact::Status::Free)
        return Outcome::FallsOut;
      // A motion ends at its first contact or at its lowest point.
      const double time = std::min(found.time, c.motion.limit);
      const double drop = m_body.sinks_by(c.motion, time);
      // A motion that hardly lowers it is none; the next one is tried.
      if (drop < least * clearance()) continue;
      m_body.execute(c.kind, c.motion, time, drop);
      m_sank = true;
      return Outcome::Moved;
    }
    return Outcome::Stuck;
  }

  // Gaps of more than two clearances count where something closer holds the object up: what merely
  // hovers is held by nothing.
  bool balance(const std::vector<ContactPoint>& near) const {
    std::vector<ContactPoint> close = near;
    std::erase_if(close,
                  [&](const ContactPoint& c) { return c.gap > kContactTolerance * clearance(); });
    const bool lies = std::any_of(close.begin(), close.end(), [](const ContactPoint& c) {
      return c.normal.z() > kSupportNormalZ;
    });
    return is_balanced(lies ? near : close);
  }

  bool is_balanced(const std::vector<ContactPoint>& contacts) const {
    return trivet::is_balanced(contacts, object().centre, object().size, clearance());
  }

  const SettleProblem& m_problem;
  SettlingBody m_body;
  bool m_sank = false;
};

}  // namespace

bool is_at_rest(const SettleProblem& problem) {
  return has_finite_friction(problem.options) ? rests_with_friction(problem)
                                              : Settling(problem).is_at_rest();
}

SettleOutcome settle(const SettleProblem& problem) {
  return has_finite_friction(problem.options) ? settle_with_friction(problem)
                                              : Settling(problem).run();
}

}  // namespace trivet
