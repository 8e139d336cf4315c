// Cholesky factorisation of a part of a dense matrix, in a fixed order: the same bits on every
// machine, which libraries that tune their blocks to caches do not give.
#pragma once

#include <vector>

#include "core/flex/dense_kernels.h"

namespace trivet::flex {

/// Kernels that this processor has, the fastest first.
const std::vector<const DenseKernels*>& usable_kernels();

/// Factors the first `num_own` columns of a symmetric matrix and subtracts their product from the
/// others. Only the lower triangle is read and written. Large ones by all threads of the arena.
/// @param a  size x size, column by column: afterwards L in its first columns.
/// @return false if it is not positive definite; `a` then means nothing.
/// Cost: about num_own x size^2 multiplications.   Re-entrant.
bool factor_front(double* a, int size, int num_own,
                  const DenseKernels& kernels = *usable_kernels().front());

/// Solves L y = x in place, of the first columns, and takes them off the others. @param x  size.
void solve_forward(const double* a, int size, int num_own, double* x,
                   const DenseKernels& kernels = *usable_kernels().front());
/// Solves L' y = x in place, of the first columns; the others are known.
void solve_backward(const double* a, int size, int num_own, double* x,
                    const DenseKernels& kernels = *usable_kernels().front());

}  // namespace trivet::flex
