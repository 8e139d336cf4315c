#include "ops/stability/fewest_movers.h"

#include <utility>

#include "ops/stability/interior_point.h"

namespace trivet {
namespace {

/// Of the fastest, from which a body is among the few.
constexpr double kShareOfFastest[] = {0.3, 0.03, 3e-3};

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
    // What does not stand among others that cannot move, falls among others that can.
    FreeBodies alone = among_ground(part, few);
    const PartForces found = quickest_forces(alone, clearance);
    if (!found.solved || found.balanced()) continue;
    std::vector<Index> out;
    for (size_t k = 0; k < few.size(); ++k)
      if (found.moves[k]) out.push_back(few[k]);
    return out;
  }
  return all;
}

}  // namespace trivet
