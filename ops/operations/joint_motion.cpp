#include "ops/operations/joint_motion.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/tunables.h"
#include "core/scene/friction.h"
#include "ops/operations/commit.h"
#include "ops/operations/group_motion.h"
#include "ops/operations/twist_groups.h"
#include "ops/settle/friction_candidates.h"
#include "ops/settle/rest.h"

namespace trivet {
namespace {

/// Parts of the size of the fastest. In the last one gaps of some clearances may close that longer
/// ones keep open, as contacts part in these; it is made only where there are such gaps.
constexpr double kSteps[] = {0.1, 0.02, 1e-3};
constexpr double kClosingStep = 1e-3;
/// Twists that differ by less, relative to the faster one, count as equal. Coarser groups where
/// finer ones block each other.
constexpr double kSame[] = {2e-3, 0.03, 0.3};
constexpr double kEnoughEnergy = 0.2;  // of the predicted drop of energy
constexpr double kAtLeast = 1e-3;      // the same, when none gets that far: creeping
constexpr int kPasses = 3;
constexpr double kStuck = 1e-3;       // of the duration: a pass in which no group gets farther
constexpr int kMaxBlockedRounds = 3;  // rounds in which some join the contacts
constexpr int kMaxJointAttempts = 8;  // each costs a few queries for each group and pass
constexpr double kSamePlace = 1e-4;   // of the size: a blocker there is a contact already
constexpr double kSameContactCosine = 0.9999;  // cosine
constexpr double kLeastJointInertia = 1e-3;    // of a mass of 1, in squares of the size

class JointMotion {
 public:
  JointMotion(Transaction& transaction, const FreeBodies& part, const std::vector<ObjectId>& ids,
              double clearance, OperationRun& run, std::int64_t max_queries, const CloseGaps& close)
      : m_transaction(transaction),
        m_scene(transaction.scene()),
        m_part(part),
        m_clearance(clearance),
        m_run(run),
        m_max_queries(max_queries),
        m_close(close) {
    // Only the bodies that topple move; all others are ground for them.
    m_active.assign(part.bodies.size(), CoulombContact::kGround);
    for (size_t i = 0; i < part.bodies.size(); ++i)
      if (std::find(ids.begin(), ids.end(), part.bodies[i].id) != ids.end()) {
        m_active[i] = static_cast<Index>(m_motion.bodies.size());
        m_motion.bodies.push_back(body_at(i));
        m_ids.push_back(part.bodies[i].id);
      }
    for (const BodyContact& t : part.touches) add_contact(t);
  }

  JointMotionResult run() {
    if (!m_motion.bodies.empty()) search();
    const bool moved = m_best && take(*m_best);
    return {moved, m_num_queries};
  }

 private:
  // Poses of the bodies after an attempt.
  struct Attempt {
    std::vector<Pose> poses;
    double gain = 0, predicted = 0;
    double least = 0;  // seconds that the group goes which is blocked first

    bool is_enough() const { return gain >= kEnoughEnergy * predicted; }
    // One that gets nowhere leaves the place to a short one that does.
    bool is_better_than(const Attempt& other) const {
      return creeps() != other.creeps() ? !creeps() : gain > other.gain;
    }
    bool creeps() const { return gain < kAtLeast * predicted; }
  };

  // Until one gets far enough, or what blocks them is known.
  void search() {
    // Long steps come first; short ones get on where long ones are blocked.
    for (const double step : kSteps)
      if ((step > kClosingStep || may_close()) && !search_with(step)) return;
  }

  // Some gaps are known, from the start or of what blocked a motion.
  bool may_close() const {
    return std::any_of(m_motion.contacts.begin(), m_motion.contacts.end(),
                       [](const CoulombContact& c) { return c.room > 0; });
  }

  // @return whether another step may get farther.
  bool search_with(double step) {
    for (int round = 0; round <= kMaxBlockedRounds; ++round) {
      solve(step);
      // Bodies that do not sink have no motion to make, unless gaps may close.
      if (!(m_motion.duration > 0) || !(predicted() > 0)) return may_close();
      if (try_groups() || has_tried_enough() || m_run.interrupt.reason()) return false;
      // Blockers join the contacts, and the first motion is found again.
      if (!join_blockers()) break;
    }
    return true;
  }

  bool has_tried_enough() const {
    return m_num_attempts >= kMaxJointAttempts || m_num_queries >= m_max_queries;
  }

  bool try_groups() {
    m_blockers.clear();
    size_t num_groups = 0;
    // Fine groups follow the twists best; coarse ones block each other less.
    for (const double same : kSame) {
      const std::vector<TwistGroup> groups = twist_groups(m_motion, same, kPartingSpeed);
      if (groups.size() == num_groups || has_tried_enough()) continue;
      num_groups = groups.size();
      const double least = keep_best(attempt(groups, m_motion.duration));
      if (m_best->is_enough()) return true;
      // In step: what goes on while others are blocked may rise.
      if (least < m_motion.duration && least > kStuck * m_motion.duration)
        keep_best(attempt(groups, least));
      if (m_best->is_enough()) return true;
    }
    return false;
  }

  // @return its least time.
  double keep_best(Attempt found) {
    ++m_num_attempts;
    const double least = found.least;
    if (!m_best || found.is_better_than(*m_best)) m_best = std::move(found);
    return least;
  }

  CoulombBody body_at(size_t i) const {
    const FreeBody& body = m_part.bodies[i];
    const Object& object = m_scene.at(body.id);
    const Mat3 linear = object.world_from_object().linear;
    const Mat3 inertia =
        inertia_per_mass(linear * object.shape->mass.covariance * linear.transpose()) +
        kLeastJointInertia * body.size * body.size * Mat3::Identity();
    return {body.centre, body.weight, body.size, inertia.inverse()};
  }

  void add_contact(const BodyContact& t) {
    Index on = m_active[t.on];
    Index from = t.from == BodyContact::kGround ? CoulombContact::kGround : m_active[t.from];
    Vec3 normal = t.contact.normal;
    // The contact is told from the side of a body that moves.
    if (on == CoulombContact::kGround) std::swap(on, from), normal = -normal;
    if (on == CoulombContact::kGround) return;
    // A contact across a gap may still close.
    const double gap = t.contact.gap;
    const double room = gap > kContactTolerance * m_clearance ? gap - m_clearance : 0;
    m_motion.contacts.push_back(
        {on, from, t.contact.point, normal, kSlidingFriction * t.friction, room});
  }

  void solve(double step) {
    FirstTwists first = first_motion(m_motion.bodies, m_motion.contacts, {kPartingSpeed, step});
    m_motion.twists = std::move(first.twists);
    double relative = 0;  // sizes a second
    for (size_t i = 0; i < m_motion.bodies.size(); ++i)
      relative = std::max(relative, m_motion.speed(i) / m_motion.bodies[i].size);
    // Bodies that closing gaps slow down would go beyond them if they went as far as free ones.
    m_motion.duration = relative > 0 ? std::min(step / relative, first.duration) : 0;
  }

  double predicted() const {
    double sum = 0;
    for (size_t i = 0; i < m_motion.bodies.size(); ++i)
      sum -= m_motion.bodies[i].weight * m_motion.twists[i].velocity.z() * m_motion.duration;
    return sum;
  }

  // --- attempts ------------------------------------------------------------------------------

  double energy() const {
    double sum = 0;
    for (const FreeBody& body : m_part.bodies)
      sum += body.weight * m_scene.at(body.id).centre_of_mass().z();
    return sum;
  }

  // Leaves the scene as it is.
  Attempt attempt(const std::vector<TwistGroup>& groups, double duration) {
    // An attempt runs in a transaction that is never committed.
    const double before = energy();
    Transaction trial(m_transaction);
    GroupMotion motion(trial, m_motion, m_ids, m_clearance, m_run);
    std::vector<double> left(groups.size(), duration);
    bool any = true;
    // Passes give those that were blocked by others another chance.
    for (int pass = 0; any && pass < kPasses; ++pass) {
      any = false;
      for (size_t g = 0; g < groups.size(); ++g) {
        if (left[g] <= kStuck * duration) continue;
        const size_t num_known = motion.blockers().size();
        const double time = motion.advance(groups[g], left[g]);
        left[g] -= time;
        any = any || time > kStuck * duration;
        if (motion.blockers().size() > num_known)
          m_blockers.emplace_back(motion.blockers().back(), duration - left[g]);
      }
    }
    m_num_queries += motion.num_queries();
    // The group that got least far sets the time for a motion in step.
    const double most_left = *std::max_element(left.begin(), left.end());
    Attempt out{{}, before - energy(), predicted(), duration - most_left};
    for (const ObjectId id : m_ids) out.poses.push_back(m_scene.at(id).pose);
    return out;
  }

  // @return whether some are new.
  bool join_blockers() {
    const size_t num_known = m_motion.contacts.size();
    for (const auto& [blocker, time] : m_blockers) {
      const auto at = blocker.with.is_floor()
                          ? m_ids.end()
                          : std::find(m_ids.begin(), m_ids.end(), blocker.with.object());
      CoulombContact c{
          blocker.body,
          at == m_ids.end() ? CoulombContact::kGround : static_cast<Index>(at - m_ids.begin()),
          blocker.point,
          blocker.normal,
          0,
          0};
      // A blocker that is a contact already says nothing new.
      if (is_known(c)) continue;
      c.friction = kSlidingFriction * friction_share(m_run.options) *
                   friction_between(m_scene, m_ids[blocker.body], blocker.with);
      Vec3 speed = m_motion.velocity(c.on, c.point);
      if (c.from != CoulombContact::kGround) speed -= m_motion.velocity(c.from, c.point);
      // The contact may close for as long as the motion went on until it was met.
      c.room = std::max(0.0, -time * c.normal.dot(speed));
      m_motion.contacts.push_back(c);
    }
    return m_motion.contacts.size() > num_known;
  }

  bool is_known(const CoulombContact& c) const {
    const double near = kSamePlace * m_motion.bodies[c.on].size;
    return std::any_of(m_motion.contacts.begin(), m_motion.contacts.end(),
                       [&](const CoulombContact& k) {
                         const double same = k.on == c.on && k.from == c.from   ? 1
                                             : k.on == c.from && k.from == c.on ? -1
                                                                                : 0;
                         return same * k.normal.dot(c.normal) > kSameContactCosine &&
                                (k.point - c.point).norm() <= near;
                       });
  }

  // --- the end -------------------------------------------------------------------------------

  bool take(const Attempt& attempt) {
    const double before = energy();
    // The poses are set in a trial, which has to pass the exact test and gain energy.
    Transaction trial(m_transaction);
    for (size_t i = 0; i < m_ids.size(); ++i)
      trial.edit(m_ids[i], [&](Object& object) { object.pose = attempt.poses[i]; });
    for (const ObjectId id : m_ids) {
      if (refuse_interpenetration(m_scene, id, m_scene.at(id).pose, true)) return false;
      link(trial, id);
    }
    // Gaps that the motion has left may close now.
    m_close(trial, m_ids);
    double lightest = kInfinity;
    for (const CoulombBody& body : m_motion.bodies) lightest = std::min(lightest, body.weight);
    const double gain = before - energy();
    if (gain < kEnergyDrop * m_clearance * lightest || gain < kAtLeast * attempt.predicted)
      return false;
    trial.commit();
    return true;
  }

  void link(Transaction& trial, ObjectId id) const {
    const Object& object = m_scene.at(id);
    commit_object(trial, id, object.pose, ObjectState::Unsupported,
                  touching(body_of(object), Neighbourhood(m_scene, id), m_clearance),
                  rest_rules(m_run.options, m_clearance));
  }

  Transaction& m_transaction;
  const Scene& m_scene;
  const FreeBodies& m_part;
  const double m_clearance;
  OperationRun& m_run;
  const std::int64_t m_max_queries;
  const CloseGaps& m_close;
  std::vector<Index> m_active;  // of the part's bodies: which of m_motion.bodies, or ground
  BeginningMotion m_motion;
  std::vector<ObjectId> m_ids;                         // of its bodies
  std::vector<std::pair<Blocker, double>> m_blockers;  // of the last attempts; seconds until then
  std::optional<Attempt> m_best;
  int m_num_attempts = 0;
  std::int64_t m_num_queries = 0;
};

}  // namespace

JointMotionResult move_jointly(Transaction& transaction, const FreeBodies& part,
                               const std::vector<ObjectId>& ids, double clearance,
                               OperationRun& run, std::int64_t max_queries,
                               const CloseGaps& close) {
  return JointMotion(transaction, part, ids, clearance, run, max_queries, close).run();
}

}  // namespace trivet
