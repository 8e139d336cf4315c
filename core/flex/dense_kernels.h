// Inner loops of dense_front.h for registers of several widths. Private.
#pragma once

namespace trivet::flex {

/// Columns that are factored before the rest is updated.
inline constexpr int kPanel = 48;

/// Tiles of `rows` rows of a panel are packed one after another, kPanel columns each, with zeros
/// where there is nothing. Every element's sum has one order, so that all kernels give the same
/// bits.
struct DenseKernels {
  int rows;  // of a tile: a multiple of four

  /// Factors the square block at `a`. @param lower  kPanel x kPanel, zeros: afterwards its rows.
  /// @return false if it is not positive definite.
  bool (*factor_block)(double* a, int size, int panel, double* lower);
  /// Divides `count` rows below the block by it, at most a tile's, and packs them.
  void (*divide_rows)(double* a, int size, int panel, int count, const double* lower,
                      double* packed);
  /// Subtracts L L' from a tile of four columns. @param a  the tile's first element.
  /// @param above  rows of the tile that are above its first diagonal element; negative: none.
  void (*update_tile)(double* a, int size, int panel, int num_rows, int num_columns, int above,
                      const double* rows, const double* columns);
  /// Subtracts factor x from.
  void (*subtract)(double* to, const double* from, double factor, int count);
  /// The sum of a x b.
  double (*product)(const double* a, const double* b, int count);
};

extern const DenseKernels kKernelsOfTwo;  // doubles in a register: every processor
#ifdef TRIVET_WIDE_KERNELS
extern const DenseKernels kKernelsOfFour;   // AVX2
extern const DenseKernels kKernelsOfEight;  // AVX-512
#endif

}  // namespace trivet::flex
