// Newton's step on the multipliers of conditions on motions. Private to small_motions.cpp.
#pragma once

#include <memory>
#include <vector>

#include "ops/mend/small_motions.h"

namespace trivet {

class BlockFactor;

/// Relaxation row by row takes thousands of sweeps where many rows hold each other. Multipliers
/// that are above their least ones solve linear equations, as long as none reaches it: these are
/// solved at once [Bertsekas 1982, projected Newton methods].
class MultiplierStep {
 public:
  /// @param rows  whose couplings the factor is made for. @param soft  see nearest_motions().
  MultiplierStep(const std::vector<MotionRow>& rows, size_t num_bodies, double soft);
  ~MultiplierStep();

  /// Changes of the multipliers, of each row, that lower the dual's objective, or none.
  std::vector<double> changes(const std::vector<MotionRow>& rows,
                              const std::vector<SmallMotion>& motions);

 private:
  std::vector<double> lacks_of(const std::vector<MotionRow>& rows, std::vector<SmallMotion> motions,
                               const std::vector<double>& changes) const;
  void free_changes(const std::vector<MotionRow>& rows, const std::vector<double>& lacks,
                    std::vector<double>& out);
  double growth(const std::vector<MotionRow>& rows, const std::vector<double>& lacks,
                const std::vector<double>& changes) const;

  size_t m_num_bodies;
  double m_soft;
  std::vector<char> m_is_free;  // of each row
  std::unique_ptr<BlockFactor> m_factor;
};

}  // namespace trivet
