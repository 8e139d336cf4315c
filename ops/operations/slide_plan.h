// Direction in which a pushed object can go on, from its contacts.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// The rise per metre beyond which a surface is not followed but climbed like a step: tan 60
/// degrees.
inline constexpr double kSteepRise = 1.7320508075688772;

/// True if a contact with this normal makes what goes in `direction` rise by more than that.
bool is_steep(const Vec3& normal, const Vec3& direction);

/// A way on: as far in the direction, seen from above, as `velocity` has metres there (one).
struct SlidePlan {
  enum class Kind {
    Go,
    Blocked,    // by contact `blocker`
    NoSupport,  // no support a little farther on
  };
  Kind kind = Kind::NoSupport;
  Vec3 velocity = Vec3::Zero();
  double lasts = 0;  // metres of the direction until the last carrying contact ends
  size_t blocker = 0;
};

/// The path straight on in `direction`, at the least height that all contacts allow: the tangent
/// of the contact surface [Shinya 1995, 4.1].
/// @param normals  unit, from what is fixed to the object. @param direction  unit, level.
/// @param ends  of contact i with a velocity: the time until it ends.
/// @param shortest  metres; contacts that end sooner do not count.
/// @param climb  whether steeper surfaces than kSteepRise may be followed; else they block.
SlidePlan plan_slide(const std::vector<Vec3>& normals, const Vec3& direction,
                     const std::function<double(size_t, const Vec3&)>& ends, double shortest,
                     bool climb);

/// The level direction nearest to `direction` that no wall among the contacts stands against;
/// nullopt: none leads on. Walls are contacts too steep to be followed, and ceilings.
std::optional<Vec3> slide_direction(const std::vector<Vec3>& normals, const Vec3& direction,
                                    size_t blocker, bool climb);

}  // namespace trivet
