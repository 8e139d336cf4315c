// Questions that relations of sight ask rays in the scene.
#pragma once

#include <algorithm>
#include <functional>

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// Tolerances; more than that costs no more: a can be out of reach altogether.
inline constexpr double kMostSightCost = 1000;

inline double sight_cost_of(const Terms& r, double missing) {
  return std::min(kMostSightCost, std::max(0.0, missing) / r.tolerance);
}

/// The scene with both objects in it.
class Sight {
 public:
  virtual ~Sight() = default;
  virtual double covered() const = 0;  // share of a, seen from above, that b is over
  virtual double seen() const = 0;     // share of what is to be seen of a from the eye
  virtual double nearest() const = 0;  // metres from the eye to the first of a that is in reach
  /// The same decisions by as few rays as they take. More is never less true.
  virtual bool sees(const std::function<bool(double share)>& is_enough) const = 0;
  virtual bool reaches(const std::function<bool(double distance)>& is_near) const = 0;
};

/// From where a is seen and reached: a point, or over b's centre.
struct Eye {
  Vec3 place(const Outline* b) const;

  std::optional<Vec3> eye;  // nullopt: over b's centre ...
  double eye_height = 1.2;  // ... so high over its lowest point
};

inline constexpr const char* kEyeHeightHelp =
    "Height of the eye over b's lowest point; default 1.2 m.";
inline constexpr const char* kEyeHelp = "Position of the eye in the world, metres.";
inline constexpr const char* kPartHelp = "Share that is seen, at least; default 0.5.";

/// Kinds that look from an eye.
struct Looking : AnyKind, Eye {
  static constexpr Other kOther = Other::Optional;
  static constexpr double kUsualTolerance = 0.01;
  static constexpr bool kIsOfSight = true, kHasLines = true;

  static std::vector<Way> ways() { return {{{"b"}, {"point"}}, {{"point"}, {"b", "height"}}}; }
  const char* wrong(const Terms& r, const IsGiven& is_given) const;
  void extend(Aabb& box) const {
    if (eye) box.extend(*eye);
  }
};

}  // namespace trivet::relations
