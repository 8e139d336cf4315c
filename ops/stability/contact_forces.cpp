#include "ops/stability/contact_forces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "ops/stability/force_program.h"
#include "ops/stability/priced_forces.h"
#include "ops/stability/unbalanced.h"

namespace trivet {
namespace {

constexpr double kRoomOfBalance = 100;    // of a limit of the objective: for rounding and scaling
constexpr double kNearlyWorst = 1e-4;     // of a margin: other orders of pivots differ by less
constexpr double kClearlyMissing = 1e-2;  // weights: more than CLP's rounding

// Takes the best candidates of each pair that would lower the cost. @return whether there are any.
template <class Gain>
bool join_best(FreeBodies& part, const Gain& gain) {
  // Gains are worked out before anything joins, so that the order of candidates does not matter.
  std::vector<double> gains;
  for (const BodyContact& t : part.more) gains.push_back(gain(t));
  std::vector<char> joins(part.more.size(), 0);
  for (const size_t k : touches_that_join(part.more, gains)) joins[k] = 1;
  std::vector<BodyContact> left;
  for (size_t k = 0; k < joins.size(); ++k)
    (joins[k] ? part.touches : left).push_back(part.more[k]);
  const bool any = left.size() < part.more.size();
  part.more = std::move(left);
  return any;
}

}  // namespace

bool PartForces::balanced() const {
  return std::all_of(missing.begin(), missing.end(), [](double m) { return m <= kMayBeMissing; });
}

std::vector<double> carried_weights(const FreeBodies& part) {
  const size_t n = part.bodies.size();
  // Contacts that face up or down tell who lies on whom.
  std::vector<std::vector<Index>> loads(n);
  for (const BodyContact& t : part.touches) {
    if (t.from == BodyContact::kGround) continue;
    if (t.contact.normal.z() > kSupportNormalZ) loads[t.from].push_back(t.on);
    if (t.contact.normal.z() < -kSupportNormalZ) loads[t.on].push_back(t.from);
  }
  std::vector<double> out(n, 0.0);
  for (size_t i = 0; i < n; ++i) {
    std::vector<char> seen(n, 0);
    // The search walks up through everything that lies on the body.
    std::vector<Index> open{static_cast<Index>(i)};
    seen[i] = 1;
    while (!open.empty()) {
      const Index body = open.back();
      open.pop_back();
      out[i] += part.bodies[body].weight + part.bodies[body].load.norm();
      for (const Index load : loads[body])
        if (!std::exchange(seen[load], 1)) open.push_back(load);
    }
  }
  return out;
}

PartForces contact_forces(FreeBodies& part, double clearance, double factor) {
  while (true) {
    // The program grows by contacts until the forces balance or no contact would help.
    ForceProgram program(part, clearance, factor);
    program.add_missing(1, kInfinity);
    const LinearProgram::Solution solution = program.solve();
    if (!solution.optimal) return {};
    PartForces out = program.forces_of(solution);
    const auto gain = [&](const BodyContact& t) { return program.gain(t, solution); };
    // Without a contact that lowers what is missing, this is the optimum over all contacts.
    if (out.balanced() || !join_best(part, gain)) return out;
  }
}

std::vector<Vec3> forces_of_carriers(const FreeBodies& part, double clearance,
                                     std::span<const MayCarry> may) {
  ForceProgram program(part, clearance, 1, may);
  program.add_missing(0, kMayBeMissing);
  const LinearProgram::Solution solution = program.solve();
  return solution.optimal ? program.forces_of(solution).forces : std::vector<Vec3>{};
}

bool quickly_balanced(const FreeBodies& part, double clearance, double factor) {
  ForceProgram program(part, clearance, factor);
  program.add_missing(1, kInfinity);
  // The dual simplex usually answers at once; contacts that were left out do not join here.
  // Its objective only grows: beyond what may be missing no balance is to be found.
  const double most = kRoomOfBalance * kMayBeMissing * static_cast<double>(part.bodies.size());
  const LinearProgram::Solution solution = program.solve_by_dual(most);
  return solution.optimal && program.forces_of(solution).balanced();
}

bool clearly_unbalanced(const FreeBodies& part, double clearance, const FreeBodies& larger,
                        const PartForces& forces_of_larger) {
  if (!forces_of_larger.solved) return false;
  std::map<std::uint32_t, VirtualMotion> known;  // by slot
  for (size_t i = 0; i < larger.bodies.size(); ++i)
    known[larger.bodies[i].id.index] = forces_of_larger.motions[i];
  std::vector<VirtualMotion> motions;
  motions.reserve(part.bodies.size());
  for (const FreeBody& body : part.bodies) motions.push_back(known[body.id.index]);
  return ForceProgram(part, clearance).least_missing(motions) > kClearlyMissing;
}

double shift_margin(const FreeBodies& part, double clearance) {
  const double d = 0.70710678118654752;
  double largest = 0, margin = kInfinity;
  for (const FreeBody& body : part.bodies) largest = std::max(largest, body.size);
  ForceProgram program(part, clearance);
  program.add_missing(0, kMayBeMissing);
  // Eight ways, seen from above, to shift all centres of mass: the margin is the least shift that
  // no forces balance.
  std::vector<LinearProgram::Column> shifts;
  for (const Vec2& way : {Vec2(1, 0), Vec2(d, d), Vec2(0, 1), Vec2(-d, d), Vec2(-1, 0),
                          Vec2(-d, -d), Vec2(0, -1), Vec2(d, -d)})
    shifts.push_back(program.shift(Vec3(way.x(), way.y(), 0), largest));
  // Shifts that may be worst are solved anew, so that the bits do not depend on the others.
  const std::vector<double> nearly = program.objectives_with(shifts);
  double worst = -kInfinity;
  for (const double objective : nearly) worst = std::max(worst, objective);
  for (size_t k = 0; k < shifts.size(); ++k) {
    if (nearly[k] < worst - kNearlyWorst * (1e-2 - worst)) continue;
    const LinearProgram::Solution solution = program.solve_with(shifts[k]);
    if (!solution.optimal) return -kInfinity;
    margin = std::min(margin, -solution.objective * largest);
  }
  return margin;
}

}  // namespace trivet
