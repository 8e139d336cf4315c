// The motions by which an object may give way, best first.
#pragma once

#include <array>
#include <vector>

#include "core/contact/contact.h"
#include "core/motion/motion.h"
#include "ops/base/outcome.h"

namespace trivet {

/// Relative speed into a contact that still counts as none.
inline constexpr double kApproach = 1e-4;
/// Relative speed at which a contact parts.
inline constexpr double kPartingSpeed = 1e-3;
/// Vertical component of the normal below which a contact does not hinder a fall.
inline constexpr double kNoSupport = 1e-6;
/// Offset, relative to the size, below which the centre is exactly over the axis.
inline constexpr double kTie = 1e-9;

/// The object as the rules see it; world, metres.
struct SettlingObject {
  Vec3 centre;            // of mass
  double radius_squared;  // of gyration
  double size;            // diagonal
};

struct Candidate {
  SettleStep::Kind kind;
  Motion motion;  // its limit: where the centre is lowest, at most a quarter turn
  double gain;    // Gauss: squared initial acceleration that the motion takes of free fall, of g^2
};

/// The turn about `axis` through `point` until `centre` is lowest, at most a quarter turn.
Motion turn_to_lowest(const Vec3& point, const Vec3& axis, const Vec3& centre);

/// Up to eight unit axes.
class Axes {
 public:
  void add(const Vec3& axis) { m_axes[m_size++] = axis; }
  const Vec3* begin() const { return m_axes.data(); }
  const Vec3* end() const { return begin() + m_size; }

 private:
  std::array<Vec3, 8> m_axes;
  size_t m_size = 0;
};

/// Axes through a point about which a turn lowers the centre fastest, or the two along a line as
/// far as a turn lowers the centre; all of them when the centre is exactly above or below.
Axes sinking_axes(const Vec3& point, const SettlingObject& object);
Axes sinking_axes(const Vec3& p, const Vec3& q, const SettlingObject& object);

/// The sticking motions of a body held by contacts with infinite friction: fall, turn about one
/// contact point, turn about the line through two; those against which no other contact stands, in
/// the order of Gauss' principle of least constraint.
/// Generalises the three cases of Shinya 1995, 5.3, which get stuck where supports differ in height
/// or slope.
/// @param fall_limit  metres.
std::vector<Candidate> gauss_candidates(const std::vector<ContactPoint>& contacts,
                                        const SettlingObject& object, double fall_limit);

/// For an object that no motion of gauss_candidates() lowers and no forces hold: turns about one
/// contact point, each on the nearest axis about which all other contacts part.
std::vector<Candidate> last_resorts(const std::vector<ContactPoint>& contacts,
                                    const SettlingObject& object);

/// The paper's three cases literally (one motion, or none when its rules call the object stable).
std::vector<Candidate> paper_candidates(const std::vector<ContactPoint>& contacts,
                                        const SettlingObject& object, double fall_limit);

}  // namespace trivet
