// Random decisions of a scene, by name: one more does not shift the others.
#pragma once

#include <string>
#include <vector>

#include "apps/farm/recipe/philox.h"
#include "core/motion/pose.h"

namespace trivet::farm {

struct Interval {
  double low = 0, high = 0;
};
struct Counts {
  int low = 0, high = 0;
};

/// The numbers of one decision of one scene: functions of (key, k, name, n), n counting the calls.
/// Integers, and doubles by + - * / and sqrt alone, which are the same bits on every machine.
class Decision {
 public:
  Decision(const PhiloxKey& key, std::uint64_t k, const std::string& name);

  /// 64 bits.
  std::uint64_t bits();
  /// In [0, 1), of 53 bits.
  double unit();
  double within(const Interval& interval);
  /// low to high, both included, all equally likely.
  int count(const Counts& counts);
  size_t index(size_t size);
  /// An index, with probability in proportion to the weights.
  size_t weighted(const std::vector<double>& weights);
  /// Uniform in the unit disc, by rejection.
  Vec2 in_disc();
  /// Any orientation, uniformly: a point in the unit ball of four dimensions, normalised.
  Rotation any_rotation();
  /// Any angle about z, uniformly.
  Rotation yaw();

 private:
  PhiloxKey m_key;
  PhiloxBlock m_counter;
};

}  // namespace trivet::farm
