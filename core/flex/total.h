// Sums that energies add to: gradient and second derivative.
#pragma once

#include <limits>

#include "core/flex/block_matrix.h"
#include "core/flex/body.h"

namespace trivet::flex {

/// Second derivatives of membranes and springs, and of contact.
enum class Curvature {
  Exact,     // of both; perhaps not positive definite
  Hybrid,    // membranes without compression, contact exact
  Positive,  // both without what is negative
};

/// Threads may share the vertices: each adds to its own, in the order of the elements, so that the
/// sums are the same for any number of shares.
struct Total {
  Points* gradient = nullptr;      // null: not asked for
  BlockMatrix* hessian = nullptr;  // the same
  Curvature curvature = Curvature::Exact;
  int first = 0, last = std::numeric_limits<int>::max();  // vertices: the last is not one of them

  bool has(int vertex) const { return vertex >= first && vertex < last; }
  /// True if an element of these vertices adds anything.
  template <class Vertices>
  bool has_any(const Vertices& vertices, int count) const {
    for (int i = 0; i < count; ++i)
      if (has(vertices[i])) return true;
    return false;
  }
  /// The energy of an element: one share alone counts it.
  double energy_of(int first_vertex, double energy) const { return has(first_vertex) ? energy : 0; }
  void add(int vertex, const Vec3& force) const {
    if (gradient && has(vertex)) (*gradient)[vertex] += force;
  }
  void add(int row, int column, const Mat3& block) const {
    if (has(row)) hessian->add(row, column, block);
  }
  /// The block (i, j) and its transpose (j, i); i != j.
  void add_both(int i, int j, const Mat3& block) const {
    add(i, j, block);
    add(j, i, block.transpose());
  }
};

/// a b'
inline Mat3 outer(const Vec3& a, const Vec3& b) {
  Mat3 out;
  for (int c = 0; c < 3; ++c) out.col(c) = a * b[c];
  return out;
}

}  // namespace trivet::flex
