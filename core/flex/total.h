// Sums that energies add to: gradient and second derivative.
#pragma once

#include "core/flex/block_matrix.h"
#include "core/flex/body.h"

namespace trivet::flex {

/// Second derivatives of membranes and springs, and of contact.
enum class Curvature {
  Exact,     // of both; perhaps not positive definite
  Hybrid,    // membranes without compression, contact exact
  Positive,  // both without what is negative
};

struct Total {
  Points* gradient = nullptr;      // null: not asked for
  BlockMatrix* hessian = nullptr;  // the same
  Curvature curvature = Curvature::Exact;

  void add(int vertex, const Vec3& force) const {
    if (gradient) (*gradient)[vertex] += force;
  }
};

/// a b'
inline Mat3 outer(const Vec3& a, const Vec3& b) {
  Mat3 out;
  for (int c = 0; c < 3; ++c) out.col(c) = a * b[c];
  return out;
}

}  // namespace trivet::flex
