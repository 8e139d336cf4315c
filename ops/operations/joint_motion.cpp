#include "ops/operations/joint_motion.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/tunables.h"
#include "ops/operations/commit.h"
#include "ops/operations/twist_groups.h"
#include "ops/settle/friction_candidates.h"
#include "ops/settle/rest.h"

namespace trivet {
namespace {

constexpr double kSteps[] = {0.1, 0.02};  // of the size of the fastest
/// Twists that differ by less, relative to the faster one, count as equal. Coarser groups where
/// finer ones block each other.
constexpr double kSame[] = {2e-3, 0.03, 0.3};
constexpr double kEnoughEnergy = 0.2;  // of the predicted drop of energy
constexpr double kAtLeast = 0.02;      // the same, when no step gets that far
constexpr int kPasses = 3;
constexpr double kOnlySlides = 1e-4;         // turning, of the speed
constexpr double kLeastJointInertia = 1e-3;  // of a mass of 1, in squares of the size

class JointMotion {
 public:
  JointMotion(Transaction& transaction, const FreeBodies& part, const std::vector<ObjectId>& ids,
              double clearance, OperationRun& run, const CloseGaps& close)
      : m_transaction(transaction),
        m_scene(transaction.scene()),
        m_part(part),
        m_clearance(clearance),
        m_run(run),
        m_close(close) {
    m_active.assign(part.bodies.size(), CoulombContact::kGround);
    for (size_t i = 0; i < part.bodies.size(); ++i)
      if (std::find(ids.begin(), ids.end(), part.bodies[i].id) != ids.end()) {
        m_active[i] = static_cast<Index>(m_motion.bodies.size());
        m_motion.bodies.push_back(body_at(i));
        m_ids.push_back(part.bodies[i].id);
      }
    for (const BodyContact& t : part.touches) add_contact(t);
  }

  bool run() { return !m_motion.bodies.empty() && (run(kEnoughEnergy) || run(kAtLeast)); }

 private:
  bool run(double enough) {
    for (const double step : kSteps) {
      solve(step);
      if (!(m_duration > 0) || !(predicted() > 0)) return false;
      size_t num_groups = 0;
      for (const double same : kSame) {
        const std::vector<TwistGroup> groups = twist_groups(m_motion, same, kPartingSpeed);
        if (groups.size() == num_groups) continue;
        num_groups = groups.size();
        if (m_run.interrupt.reason()) return false;
        if (attempt(groups, enough)) return true;
      }
    }
    return false;
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
    if (on == CoulombContact::kGround) std::swap(on, from), normal = -normal;
    if (on == CoulombContact::kGround) return;
    m_motion.contacts.push_back(
        {on, from, t.contact.point, normal, kSlidingFriction * t.friction, 0});
  }

  void solve(double step) {
    m_motion.twists = first_motion(m_motion.bodies, m_motion.contacts, {kPartingSpeed, step});
    double relative = 0;  // sizes a second
    for (size_t i = 0; i < m_motion.bodies.size(); ++i)
      relative = std::max(relative, m_motion.speed(i) / m_motion.bodies[i].size);
    m_duration = relative > 0 ? step / relative : 0;
  }

  double predicted() const {
    double sum = 0;
    for (size_t i = 0; i < m_motion.bodies.size(); ++i)
      sum -= m_motion.bodies[i].weight * m_motion.twists[i].velocity.z() * m_duration;
    return sum;
  }

  // --- motions -------------------------------------------------------------------------------

  double energy(const Scene& scene) const {
    double sum = 0;
    for (const FreeBody& body : m_part.bodies)
      sum += body.weight * scene.at(body.id).centre_of_mass().z();
    return sum;
  }

  bool attempt(const std::vector<TwistGroup>& groups, double enough) {
    const double before = energy(m_scene);
    Transaction trial(m_transaction);
    std::vector<ObjectId> moved;
    for (const TwistGroup& group : groups)
      for (const Index i : group.members) moved.push_back(m_ids[i]);
    std::vector<double> left(groups.size(), m_duration);
    for (int pass = 0; pass < kPasses; ++pass)
      for (size_t g = 0; g < groups.size(); ++g)
        if (left[g] > 1e-3 * m_duration) left[g] -= advance(trial, groups[g], left[g]);
    for (const ObjectId id : moved) {
      if (refuse_interpenetration(m_scene, id, m_scene.at(id).pose, true)) return false;
      link(trial, id);
    }
    m_close(trial, moved);
    double lightest = kInfinity;
    for (const CoulombBody& body : m_motion.bodies) lightest = std::min(lightest, body.weight);
    const double gain = before - energy(m_scene);
    if (gain < kEnergyDrop * m_clearance * lightest || gain < enough * predicted()) return false;
    trial.commit();
    return true;
  }

  void link(Transaction& trial, ObjectId id) const {
    const Object& object = m_scene.at(id);
    commit_object(trial, id, object.pose, ObjectState::Unsupported,
                  touching(body_of(object), Neighbourhood(m_scene, id), m_clearance),
                  rest_rules(m_run.options, m_clearance));
  }

  // A screw is no exact motion: its turn, then its translation.
  // @return the seconds of it that it gets.
  double advance(Transaction& trial, const TwistGroup& group, double duration) const {
    const Twist& t = group.twist;
    const double rate = t.turning.norm();
    if (rate * m_motion.bodies[group.leader].size < kOnlySlides * t.velocity.norm())
      return duration * go(trial, group, t.velocity, duration);
    const Vec3 axis = t.turning / rate;
    const double pitch = t.velocity.dot(axis);
    const Vec3 across = t.velocity - pitch * axis;
    const Vec3 centre =
        m_scene.at(m_ids[group.leader]).centre_of_mass() + t.turning.cross(across) / (rate * rate);
    const double part =
        execute(trial, group, Motion::rotation(centre, axis, std::min(0.5 * rate * duration, 1.0)));
    if (part >= 1 && std::abs(pitch) * duration > 0.1 * m_clearance)
      go(trial, group, pitch * axis, duration);
    return duration * part;
  }

  double go(Transaction& trial, const TwistGroup& group, const Vec3& velocity,
            double duration) const {
    const double length = velocity.norm() * duration;
    return length > 0 ? execute(trial, group, Motion::translation(velocity.normalized(), length))
                      : 1;
  }

  // @return the part of the motion that it gets.
  double execute(Transaction& trial, const TwistGroup& group, const Motion& motion) const {
    std::vector<ObjectId> ids;
    std::vector<Body> bodies;
    for (const Index i : group.members) {
      ids.push_back(m_ids[i]);
      bodies.push_back(body_of(m_scene.at(m_ids[i])));
    }
    Clearance keep;
    keep.distance = m_clearance;
    const ObstacleContact found =
        first_contact(bodies, Neighbourhood(m_scene, ids), motion, keep, m_run.detector);
    if (found.status == FirstContact::Status::Crossing) return 0;
    const double time = std::min(found.time, motion.limit);
    for (const ObjectId id : ids)
      trial.edit(id, [&](Object& object) { object.pose = moved_pose(object.pose, motion, time); });
    return time / motion.limit;
  }

  Transaction& m_transaction;
  const Scene& m_scene;
  const FreeBodies& m_part;
  const double m_clearance;
  OperationRun& m_run;
  const CloseGaps& m_close;
  std::vector<Index> m_active;  // of the part's bodies: which of m_motion.bodies, or ground
  BeginningMotion m_motion;
  std::vector<ObjectId> m_ids;  // of its bodies
  double m_duration = 0;
};

}  // namespace

bool move_jointly(Transaction& transaction, const FreeBodies& part,
                  const std::vector<ObjectId>& ids, double clearance, OperationRun& run,
                  const CloseGaps& close) {
  return JointMotion(transaction, part, ids, clearance, run, close).run();
}

}  // namespace trivet
