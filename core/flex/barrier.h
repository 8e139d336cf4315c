// The energy by which contact keeps a distance [Li 2020, IPC], and its derivatives.
#pragma once

#include "core/base/logarithm.h"

namespace trivet::flex {

/// Zero from `layer` on, infinite at gap 0; twice continuously differentiable in between.
struct Barrier {
  double value = 0, first = 0, second = 0;

  Barrier(double gap, double layer) {
    if (gap >= layer) return;
    const double inner = gap - layer, logarithm = natural_logarithm(gap / layer);
    value = -inner * inner * logarithm;
    first = -2 * inner * logarithm - inner * inner / gap;
    second = -2 * logarithm - 4 * inner / gap + inner * inner / (gap * gap);
  }
};

}  // namespace trivet::flex
