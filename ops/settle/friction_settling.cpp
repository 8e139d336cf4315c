#include "ops/settle/friction_settling.h"

#include <algorithm>
#include <optional>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/scene.h"
#include "ops/settle/friction_candidates.h"
#include "ops/settle/settling_body.h"

namespace trivet {
namespace {

constexpr double kEnoughDrop = 0.2;     // of the predicted drop: the motion was no creeping
constexpr double kEnoughOfSize = 1e-3;  // a drop that is never small
constexpr int kMaxBlockers = 8;         // that join the contacts of one motion
constexpr int kMaxSmallSteps = 60;      // accepted in all, when nothing better is found
constexpr double kClosing = 2 * kBalanceTolerance;  // clearances that closing gaps may move it
constexpr double kLongestSlide = 4;                 // steps, where the contact goes on
constexpr double kScrewSteps[] = {1, 0.2};          // parts of a step
/// Part of the tolerance of perfect friction: marginal rest is none in other programs.
constexpr double kTolerated = 0.3;
constexpr size_t kMaxMotions = 1000;  // creeping

class FrictionSettling {
 public:
  explicit FrictionSettling(const SettleProblem& problem) : m_problem(problem), m_body(problem) {}

  SettleOutcome run() {
    const size_t most = static_cast<size_t>(m_problem.options.max_motions);
    while (m_body.outcome().steps.size() <= most && !has_asked_enough()) {
      // An interruption leaves the object where it came to; the caller decides what that is worth.
      if (m_problem.interrupt && m_problem.interrupt->reason())
        return m_body.finish(SettleOutcome::Status::Interrupted);
      const std::vector<ContactPoint> points = look_around();
      // Gaps that became too small are opened first, as motions need room to begin.
      if (m_body.separate_if_needed(points)) continue;
      // Rest is asked before any motion: what is held does not move.
      if (is_held() == Hold::Firmly || has_closed_too_much())
        return m_body.finish(SettleOutcome::Status::AtRest);
      switch (give_way()) {
        case Outcome::Moved:
          break;
        case Outcome::Stuck:
          return finish_stuck();
        case Outcome::FallsOut:
          return m_body.finish(SettleOutcome::Status::FallsOut);
        case Outcome::Crossing:
          return m_body.finish(SettleOutcome::Status::Crossing);
      }
    }
    return m_body.finish(SettleOutcome::Status::TooManyMotions);
  }

  bool is_at_rest() {
    look_around();
    return is_held() != Hold::No;
  }

 private:
  enum class Hold {
    No,
    Nearly,  // by contacts that are farther away than touching ones
    Firmly,
  };
  enum class Outcome { Moved, Stuck, FallsOut, Crossing };

  const SettlingObject& object() const { return m_body.object(); }
  double clearance() const { return m_body.clearance(); }
  bool has_asked_enough() const {
    return m_problem.max_queries > 0 && m_body.outcome().num_queries >= m_problem.max_queries;
  }
  size_t num_steps() const { return m_body.outcome().steps.size(); }
  RubbingObject rubbing() const { return {object(), m_body.inertia_per_mass(), clearance()}; }

  std::vector<ContactPoint> look_around() {
    std::vector<ContactPoint> points = m_body.look_around();
    m_close = m_body.friction_points(kContactTolerance);
    return points;
  }

  // --- rest ------------------------------------------------------------------------------------

  static bool are_the_same(const std::vector<FrictionContact>& a,
                           const std::vector<FrictionContact>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const FrictionContact& x, const FrictionContact& y) {
                        return x.point == y.point && x.normal == y.normal &&
                               x.friction == y.friction;
                      });
  }

  bool balances(const std::vector<FrictionContact>& contacts) const {
    const double enough = kTolerated * residual_tolerance(object().size, clearance());
    return !contacts.empty() && forces_balance(contacts, object().centre, object().size, enough);
  }

  // No turn lowers it that no friction can hinder: it does not merely balance on a tip.
  bool none_topples(const std::vector<FrictionContact>& contacts) {
    const double tolerance = kBalanceTolerance * clearance();
    const std::vector<Candidate> turns = sticking_turns(contacts, rubbing(), true);
    return !m_body.any_can_sink(turns, tolerance);
  }

  Hold is_held() {
    // The polygon of contacts whose cones hold a vertical force decides most cases.
    if (friction_margin(m_close, object().centre) >= kRestMargin * object().size)
      return Hold::Firmly;
    // Balanced forces hold an object unless it merely stands on a tip.
    if (balances(m_close)) return none_topples(m_close) ? Hold::Firmly : Hold::No;
    if (!lies_on_something()) return Hold::No;
    // Contacts a little farther away may hold it, once their gaps are closed; the place is
    // remembered for then.
    const std::vector<FrictionContact> near = m_body.friction_points(kCarryingTolerance);
    if (are_the_same(near, m_close) || !balances(near) || topples_on_the_way(near)) return Hold::No;
    if (!m_held_at) m_held_at = {m_body.here(), object().centre};
    return Hold::Nearly;
  }

  // Until enough gaps are closed, one after the other. So it stays at rest where the scene, and
  // with it the clearance, grows: what is close then is one of these sets.
  bool topples_on_the_way(std::vector<FrictionContact> near) {
    std::stable_sort(near.begin(), near.end(),
                     [](const auto& a, const auto& b) { return a.gap < b.gap; });
    std::vector<FrictionContact> closed = m_close;
    while (!balances(closed)) {
      if (!none_topples(closed)) return true;
      const size_t more = std::min(closed.size() + 1, near.size());
      closed.assign(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(more));
    }
    return false;
  }

  // An object that merely hovers is held by nothing, however near that is.
  bool lies_on_something() const {
    return std::any_of(m_close.begin(), m_close.end(),
                       [](const FrictionContact& c) { return c.normal.z() > kSupportNormalZ; });
  }

  // Held by contacts that are near it may close their gaps, but not go on from there.
  bool has_closed_too_much() {
    if (!m_held_at || (object().centre - m_held_at->centre).norm() <= kClosing * clearance())
      return false;
    go_back_to_hold();
    return true;
  }

  void go_back_to_hold() {
    m_body.go_back(m_held_at->place);
    look_around();
  }

  SettleOutcome finish_stuck() {
    if (!m_held_at) return m_body.finish(SettleOutcome::Status::Wedged);
    if (is_held() == Hold::No) go_back_to_hold();
    return m_body.finish(SettleOutcome::Status::AtRest);
  }

  // --- motions ---------------------------------------------------------------------------------

  /// A motion as far as it gets.
  struct Trial {
    Candidate candidate;
    double time = 0, drop = 0;
  };

  Outcome give_way() {
    m_best.reset();
    // Each round adds the contacts that blocked the last motion; after that it may slide along
    // them.
    const RubbingObject body = rubbing();
    std::vector<FrictionContact> contacts = m_close;
    CoulombMotions first;
    for (int round = 0; round <= kMaxBlockers; ++round) {
      const size_t num_known = contacts.size();
      first = coulomb_motions(contacts, body);
      std::vector<Candidate>& motions = first.exact;
      // Falls and turns do not change by blockers, so that they are tried in the first round alone.
      if (round == 0) {
        for (const Candidate& c : fall(m_close, m_body.fall_limit())) motions.push_back(c);
        for (const Candidate& c : sticking_turns(m_close, body, false)) motions.push_back(c);
      }
      // The motion that gains most is tried first; slides without friction come last, as the least
      // likely.
      sort_by_gain(motions);
      for (const Candidate& c : frictionless_slide(contacts, body)) motions.push_back(c);
      for (size_t i = 0; i < motions.size(); ++i) {
        if (i == 1) foresee_after_first(motions);
        if (const auto done = attempt(motions[i], contacts)) return *done;
      }
      // Without a new blocker the next round would find the same motions.
      if (contacts.size() == num_known) break;
    }
    // A whole screw may lower the object where no exact motion does.
    if (first.duration > 0 && execute_screw(contacts, body, first)) return Outcome::Moved;
    return take_best();
  }

  // Most often the first one moves it: the others are asked about, together, when it does not.
  void foresee_after_first(const std::vector<Candidate>& candidates) {
    std::vector<Motion> motions;
    for (size_t i = 1; i < candidates.size(); ++i)
      motions.push_back(as_tried(candidates[i]).motion);
    m_body.foresee(motions);
  }

  // As far as it is tried.
  Candidate as_tried(Candidate c) const {
    // A slide that went on may go twice as far the next time.
    if (c.kind == SettleStep::Kind::Slide && c.motion.kind == Motion::Kind::Translation)
      c.motion.limit *= m_slide_steps;
    if (c.motion.kind == Motion::Kind::Rotation)
      c.motion.limit = std::min(c.motion.limit, m_problem.longest_turn);
    return c;
  }

  // Executes it if it gets far enough. @return nothing if it does not; what blocks it joins the
  // contacts then.
  std::optional<Outcome> attempt(const Candidate& candidate,
                                 std::vector<FrictionContact>& contacts) {
    const Candidate c = as_tried(candidate);
    const bool slides = c.kind == SettleStep::Kind::Slide;
    const ObstacleContact found = m_body.query(c.motion);
    // Objects that overlap from the start can be moved by nothing.
    if (found.status == FirstContact::Status::Crossing && num_steps() == 0)
      return Outcome::Crossing;
    if (c.kind == SettleStep::Kind::Fall && found.status == FirstContact::Status::Free)
      return Outcome::FallsOut;
    const double time = std::min(found.time, c.motion.limit);
    const Trial trial{c, time, m_body.sinks_by(c.motion, time)};
    // A motion counts if it gets a fair part of its way, or a fair part of the size.
    const double predicted = m_body.sinks_by(c.motion, c.motion.limit);
    if (trial.drop >= kEnergyDrop * clearance() &&
        trial.drop >= std::min(kEnoughDrop * predicted, kEnoughOfSize * object().size)) {
      execute(trial);
      return Outcome::Moved;
    }
    // The motion that gets farthest is kept, in case nothing better comes.
    if (!m_best || trial.drop > m_best->drop) m_best = trial;
    // The blocker of a slide takes part in the next first motion, with its own friction.
    if (slides && found.status == FirstContact::Status::Contact)
      contacts.push_back(
          {{found.point, found.normal, found.gap, ContactFeatures::ClosestPoints, 0, 0},
           friction_with(found)});
    return std::nullopt;
  }

  bool execute_screw(const std::vector<FrictionContact>& contacts, const RubbingObject& body,
                     const CoulombMotions& first) {
    return std::any_of(std::begin(kScrewSteps), std::end(kScrewSteps), [&](double part) {
      return execute_screw(contacts, body, first.screw, part * first.duration);
    });
  }

  // The screw in three motions, none of which has to lower the object; all together have to.
  bool execute_screw(const std::vector<FrictionContact>& contacts, const RubbingObject& body,
                     const Twist& screw, double duration) {
    // The object moves out of the way, turns, and comes back with the slide along the axis.
    const auto motions = screw_motions(contacts, body, screw, duration);
    if (!motions) return false;
    const SettlingBody::Place start = m_body.here();
    const double before = object().centre.z();
    const double away = go(SettleStep::Kind::Lift, motions->away);
    const double turned = go(SettleStep::Kind::Slide, motions->turn) / motions->turn.limit;
    // The way back undoes the way out, and adds as much of the screw's advance as the turn has
    // made.
    const Vec3 back = turned * motions->along - away * motions->away.axis;
    const double length = back.norm();
    if (length > 0) go(SettleStep::Kind::Slide, Motion::translation(back / length, length));
    // All three together have to lower it enough; otherwise it stands where it stood.
    const double drop = before - object().centre.z();
    if (drop >= kEnergyDrop * clearance() && drop >= -kEnoughDrop * screw.velocity.z() * duration)
      return true;
    m_body.go_back(start);
    m_body.update();
    return false;
  }

  double go(SettleStep::Kind kind, const Motion& motion) {
    if (!(motion.limit > 0)) return 0;
    const double time = std::min(m_body.query(motion).time, motion.limit);
    m_body.execute(kind, motion, time, m_body.sinks_by(motion, time));
    m_body.update();
    return time;
  }

  double friction_with(const ObstacleContact& found) const {
    return m_body.friction_with(found.moving, found.with);
  }

  void execute(const Trial& t) {
    const Motion& m = t.candidate.motion;
    // A slide that ran its whole way found the surface going on, and may go farther next time.
    const bool slid = t.candidate.kind == SettleStep::Kind::Slide &&
                      m.kind == Motion::Kind::Translation && t.time >= m.limit;
    // A fall closes the gap that a slide opens.
    if (slid)
      m_slide_steps = std::min(2 * m_slide_steps, kLongestSlide);
    else if (t.candidate.kind != SettleStep::Kind::Fall ||
             t.drop > kFlatSlide * m_slide_steps * object().size)
      m_slide_steps = 1;
    m_body.execute(t.candidate.kind, m, t.time, t.drop);
  }

  // The motion that gets farthest, though not far: a limited number of times.
  Outcome take_best() {
    // Small steps are limited, as they may creep without end.
    if (num_steps() >= kMaxMotions || m_num_small_steps >= kMaxSmallSteps) return Outcome::Stuck;
    if (!m_best || m_best->drop < kLastEnergyDrop * clearance()) return Outcome::Stuck;
    ++m_num_small_steps;
    execute(*m_best);
    return Outcome::Moved;
  }

  static constexpr double kFlatSlide = 1e-3;  // of the size: the surface went on

  struct HeldAt {
    SettlingBody::Place place;
    Vec3 centre;
  };

  const SettleProblem& m_problem;
  SettlingBody m_body;
  std::vector<FrictionContact> m_close;
  std::optional<HeldAt> m_held_at;
  std::optional<Trial> m_best;
  double m_slide_steps = 1;
  int m_num_small_steps = 0;
};

}  // namespace

SettleOutcome settle_with_friction(const SettleProblem& problem) {
  return FrictionSettling(problem).run();
}

bool rests_with_friction(const SettleProblem& problem) {
  return FrictionSettling(problem).is_at_rest();
}

}  // namespace trivet
