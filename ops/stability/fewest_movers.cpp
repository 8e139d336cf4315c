#include "ops/stability/fewest_movers.h"

#include <algorithm>
#include <utility>

#include "ops/stability/interior_point.h"

namespace trivet {
namespace {

/// Part of the fastest one's speed, from which a body is among the few.
constexpr double kShareOfFastest[] = {0.3, 0.03, 3e-3};

constexpr size_t kFew = 8;  // bodies that are asked first

double fastest_point(const VirtualMotion& motion, const FreeBody& body) {
  return motion.velocity.norm() + motion.spin.norm() * body.size / 2;
}

// These bodies alone: all others are ground, which loads nothing.
FreeBodies among_ground(const FreeBodies& part, const std::vector<Index>& chosen) {
  std::vector<Index> place(part.bodies.size(), BodyContact::kGround);
  FreeBodies out;
  for (const Index i : chosen) {
    place[i] = static_cast<Index>(out.bodies.size());
    out.bodies.push_back(part.bodies[i]);
  }
  const auto add = [&](const std::vector<BodyContact>& from, std::vector<BodyContact>& to) {
    for (BodyContact t : from) {
      t.on = place[t.on];
      if (t.from != BodyContact::kGround) t.from = place[t.from];
      // The touch is told from the side of a body that is there.
      if (t.on == BodyContact::kGround)
        std::swap(t.on, t.from), t.contact.normal = -t.contact.normal;
      if (t.on != BodyContact::kGround) to.push_back(t);
    }
  };
  add(part.touches, out.touches);
  add(part.more, out.more);
  return out;
}

// Those of them that move while the others stand still; none: these stand so.
std::vector<Index> movers_among(const FreeBodies& part, const std::vector<Index>& chosen,
                                double clearance) {
  FreeBodies alone = among_ground(part, chosen);
  const PartForces found = quickest_forces(alone, clearance);
  std::vector<Index> out;
  if (!found.solved || found.balanced()) return out;
  for (size_t k = 0; k < chosen.size(); ++k)
    if (found.moves[k]) out.push_back(chosen[k]);
  return out;
}

}  // namespace

std::vector<Index> fewest_movers(const FreeBodies& part, double clearance,
                                 const PartForces& forces) {
  std::vector<Index> all;
  for (size_t i = 0; i < part.bodies.size(); ++i)
    if (forces.moves[i]) all.push_back(static_cast<Index>(i));
  for (const double share : kShareOfFastest) {
    std::vector<Index> few;
    for (const Index i : all)
      if (fastest_point(forces.motions[i], part.bodies[i]) >= share) few.push_back(i);
    if (few.size() == all.size()) break;
    if (few.empty()) continue;
    // A body that falls among others that cannot move, falls among others that can.
    std::vector<Index> out = movers_among(part, few, clearance);
    if (!out.empty()) return out;
  }
  // Of a motion that is not the optimum's nearly all bodies take part.
  const std::vector<Index> out = movers_among(part, all, clearance);
  return out.empty() ? all : out;
}

PartForces disproof_by_few(const FreeBodies& part, std::span<const ObjectId> changed,
                           double clearance) {
  std::vector<Index> seeds;
  for (size_t i = 0; i < part.bodies.size(); ++i)
    if (std::find(changed.begin(), changed.end(), part.bodies[i].id) != changed.end())
      seeds.push_back(static_cast<Index>(i));
  if (seeds.empty()) return {};
  const std::vector<Index> few = nearest_bodies(part, seeds, kFew);
  FreeBodies alone = among_ground(part, few);
  const PartForces found = contact_forces(alone, clearance);
  if (!found.solved || found.balanced()) return {};
  PartForces out;
  out.missing.assign(part.bodies.size(), 0.0);
  out.moves.assign(part.bodies.size(), false);
  out.motions.assign(part.bodies.size(), {});
  for (size_t k = 0; k < few.size(); ++k) {
    out.missing[few[k]] = found.missing[k];
    out.moves[few[k]] = found.moves[k];
    out.motions[few[k]] = found.motions[k];
  }
  out.residual = found.residual;
  // Among ground limits of pushes are those of less weight: the whole part is asked.
  out.solved = proves_lack_of_balance(out.motions, part, clearance);
  return out;
}

}  // namespace trivet
