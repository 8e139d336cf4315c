#include "ops/settle/rest.h"

#include <algorithm>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/friction.h"
#include "ops/placement/verify.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/friction_settling.h"
#include "ops/settle/least_friction.h"
#include "ops/settle/settle.h"

namespace trivet {
namespace {

constexpr int kMotionsOfStuck = 8;  // that a wedged object may make to close gaps

Vec3 centre_at(const Object& object, const Pose& pose) {
  return body_of(object, pose).world_from_object.apply(object.shape->mass.centre);
}

double own_margin(const Scene& scene, const Object& object, const Pose& pose,
                  const std::vector<ContactsWith>& contacts, const RestRules& rules) {
  return tipping_margin(scene, object, centre_at(object, pose), contacts, rules);
}

SettleProblem problem_at(const Object& object, const Pose& pose, const Neighbourhood& others,
                         const RestRules& rules) {
  SettleProblem problem;
  problem.shape = object.shape.get();
  problem.up = object.up;
  problem.scale = object.scale;
  problem.surface = surface_of(object);
  problem.start = pose;
  problem.others = &others;
  problem.clearance = rules.clearance;
  problem.options.perfect_friction = rules.perfect_friction;
  return problem;
}

// Lets it go: whether it gets no farther than closing gaps takes.
bool is_stuck(SettleProblem problem, const Vec3& centre_of_shape) {
  // A wedged object may close gaps, but gets no farther.
  problem.options.max_motions = kMotionsOfStuck;
  const SettleOutcome outcome = settle(problem);
  if (outcome.status != SettleOutcome::Status::Wedged) return false;
  const auto centre = [&](const Pose& pose) {
    return world_from_object(pose, problem.up, problem.scale).apply(centre_of_shape);
  };
  return (centre(outcome.pose) - centre(problem.start)).norm() <=
         kBalanceTolerance * problem.clearance;
}

}  // namespace

std::vector<FrictionContact> friction_contacts(const Scene& scene, const Surface& surface,
                                               const std::vector<ContactsWith>& contacts,
                                               double distance) {
  std::vector<FrictionContact> out;
  for (const ContactsWith& c : contacts) {
    // Friction belongs to a pair of surfaces, so it is looked up for each partner.
    const double of_pair = friction_between(scene, surface, c.with);
    for (const ContactPoint& p : merged(c.points, distance)) out.push_back({p, of_pair});
  }
  return out;
}

double tipping_margin(const Scene& scene, const Object& object, const Vec3& centre,
                      const std::vector<ContactsWith>& contacts, const RestRules& rules) {
  const double distance = kContactTolerance * rules.clearance;
  // Perfect friction counts every contact that can carry; finite friction those within their cones.
  if (rules.perfect_friction) return carrying_margin(all_points(contacts, distance), centre);
  return friction_margin(friction_contacts(scene, surface_of(object), contacts, distance), centre);
}

RestRules rest_rules(const SettleOptions& options, double clearance) {
  return {clearance, !has_finite_friction(options)};
}

RestRules rules_by_links(const Object& object, const RestRules& rules) {
  const double reach = rules.perfect_friction ? kBalanceTolerance : kCarryingTolerance;
  double known = 0;
  for (const ObjectContact& entry : object.contacts)
    for (const ContactPoint& p : entry.contact.points)
      known = std::max(known, p.gap / (entry.across_gap ? reach : kContactTolerance));
  RestRules out = rules;
  // Rounding makes no other clearance.
  if (known > 1.001 * rules.clearance)
    out.clearance = std::min(known, kMostShrunk * rules.clearance);
  return out;
}

bool rests_at(const Object& object, const Pose& pose, const Neighbourhood& others,
              const RestRules& rules) {
  return is_at_rest(problem_at(object, pose, others, rules));
}

ObjectState state_at(const Object& object, const Pose& pose, const Neighbourhood& others,
                     const RestRules& rules) {
  const SettleProblem problem = problem_at(object, pose, others, rules);
  // A free-hanging object is unsupported; one that touches and cannot move is wedged.
  if (is_at_rest(problem)) return ObjectState::Stable;
  const bool touches = !touching(body_of(object, pose), others, rules.clearance).empty();
  return touches && is_stuck(problem, object.shape->mass.centre) ? ObjectState::Wedged
                                                                 : ObjectState::Unsupported;
}

Neighbourhood holders(const Scene& scene, ObjectId id) {
  Neighbourhood out(scene, id);
  out.leave_out(passed_through(scene, id));
  return out;
}

RestRating rate_rest(const Scene& scene, ObjectId id, const Pose& pose,
                     const std::vector<ContactsWith>& contacts, const RestRules& rules) {
  const Object& object = scene.at(id);
  const double size = size_of(object), tolerance = residual_tolerance(size, rules.clearance);
  const auto least = [&](const std::vector<ContactsWith>& all, double distance) {
    return least_friction(all_points(all, distance), centre_at(object, pose), size, tolerance);
  };
  RestRating out{own_margin(scene, object, pose, contacts, rules),
                 least(contacts, kContactTolerance * rules.clearance)};
  // Contacts that close under load may hold with less friction.
  if (rules.perfect_friction || out.least_friction <= object.material.friction) return out;
  const double distance = kCarryingTolerance * rules.clearance;
  const double of_near = least(contacts_with(body_of(object, pose), Neighbourhood(scene, id),
                                             distance, kFootSlack * rules.clearance),
                               distance);
  out.least_friction = std::min(out.least_friction, of_near);
  return out;
}

RestRating rate_unheld(const Scene& scene, const Object& object, const Pose& pose,
                       const std::vector<ContactsWith>& contacts, const RestRules& rules) {
  return {own_margin(scene, object, pose, contacts, rules), kInfinity};
}

RestRating rating_by_links(const Scene& scene, ObjectId id, const RestRules& rules) {
  // Fixed objects need nothing to rest.
  const Object& object = scene.at(id);
  if (object.fixed) return {};
  const std::vector<ContactsWith> contacts = linked_contacts(object);
  const bool rests = object.state == ObjectState::Stable || object.state == ObjectState::Wedged;
  return rests ? rate_rest(scene, id, object.pose, contacts, rules)
               : rate_unheld(scene, object, object.pose, contacts, rules);
}

}  // namespace trivet
