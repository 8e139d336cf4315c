// Matrices of nodes and their products, the same bits wherever they are computed.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "core/base/types.h"

namespace trivet {

/// Row by row; the bottom row matters only in products, as files may store anything there.
using Matrix4 = std::array<std::array<double, 4>, 4>;

inline Matrix4 identity_matrix4() {
  return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

/// Sums from left to right, as Eigen's packet product does on every x86-64.
inline Matrix4 product(const Matrix4& a, const Matrix4& b) {
  Matrix4 out;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) {
      double sum = a[r][0] * b[0][c];
      for (int k = 1; k < 4; ++k) sum += a[r][k] * b[k][c];
      out[r][c] = sum;
    }
  return out;
}

inline Affine affine_of(const Matrix4& m) {
  Affine out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out.linear(r, c) = m[r][c];
    out.translation[r] = m[r][3];
  }
  return out;
}

inline double determinant(const Affine& a) {
  const Mat3& m = a.linear;
  return m.col(0).dot(m.col(1).cross(m.col(2)));
}

/// True if it turns inside and outside round.
inline bool mirrors(const Affine& a) { return determinant(a) < 0; }

/// True if solids have no volume behind it.
inline bool flattens(const Affine& a) { return determinant(a) == 0; }

}  // namespace trivet
