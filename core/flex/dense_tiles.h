// The inner loops of dense_kernels.h, compiled once for each width of registers: includes nothing
// whose functions the linker could share between processors. Private.
#pragma once

#include "core/flex/dense_kernels.h"

namespace trivet::flex {

/// @param Lanes  a vector of doubles, by gcc's extension.
template <class Lanes>
class DenseTiles {
 public:
  static constexpr int kLanes = sizeof(Lanes) / sizeof(double);
  static constexpr int kRows = 2 * kLanes, kColumns = 4;

  static constexpr DenseKernels kernels() {
    return {kRows, factor_block, divide_rows, update_tile, subtract, product};
  }

 private:
  struct Tile {
    Lanes top[kColumns], bottom[kColumns];
  };

  static Lanes load(const double* from) {
    Lanes out;
    __builtin_memcpy(&out, from, sizeof out);
    return out;
  }
  static void store(Lanes values, double* to) { __builtin_memcpy(to, &values, sizeof values); }

  static void subtract(double* to, const double* from, double factor, int count) {
    // Whole registers come first and single elements last: each has the same operations.
    int i = 0;
    for (; i + kLanes <= count; i += kLanes) store(load(to + i) - factor * load(from + i), to + i);
    for (; i < count; ++i) to[i] -= factor * from[i];
  }

  // Eight sums, whatever the registers: each takes every eighth product.
  static double product(const double* a, const double* b, int count) {
    constexpr int kSums = 8, kRegisters = kSums / kLanes;
    Lanes sums[kRegisters] = {};
    int i = 0;
    for (; i + kSums <= count; i += kSums)
      for (int k = 0; k < kRegisters; ++k)
        sums[k] += load(a + i + k * kLanes) * load(b + i + k * kLanes);
    double all[kSums];
    __builtin_memcpy(all, sums, sizeof all);
    double out = ((all[0] + all[1]) + (all[2] + all[3])) + ((all[4] + all[5]) + (all[6] + all[7]));
    for (; i < count; ++i) out += a[i] * b[i];
    return out;
  }

  static bool factor_block(double* a, int size, int panel, double* lower) {
    for (int j = 0; j < panel; ++j) {
      double* const own = a + static_cast<long>(j) * size;
      // The columns before it in the panel are taken off first.
      for (int k = 0; k < j; ++k) {
        const double* const before = a + static_cast<long>(k) * size;
        subtract(own + j, before + j, before[j], panel - j);
      }
      // A pivot that is not positive means that the matrix is not positive definite; the caller
      // takes another one.
      if (!(own[j] > 0) || !__builtin_isfinite(own[j])) return false;
      own[j] = __builtin_sqrt(own[j]);
      const double inverse = 1 / own[j];
      for (int i = j + 1; i < panel; ++i) own[i] *= inverse;
      for (int i = j; i < panel; ++i) lower[i * kPanel + j] = own[i];
    }
    return true;
  }

  static void divide_rows(double* a, int size, int panel, int count, const double* lower,
                          double* packed) {
    const auto column = [&](int k) { return a + static_cast<long>(k) * size; };
    // Rows are packed, divided in place, and put back into their columns.
    for (int k = 0; k < panel; ++k)
      for (int i = 0; i < count; ++i) packed[k * kRows + i] = column(k)[i];
    for (int j = 0; j < panel; j += kColumns) divide_columns(j, panel, lower, packed);
    for (int k = 0; k < panel; ++k)
      for (int i = 0; i < count; ++i) column(k)[i] = packed[k * kRows + i];
  }

  // Four columns by those before, then by each other; behind the panel all are zero.
  static void divide_columns(int first, int panel, const double* lower, double* packed) {
    // Four columns of a tile stay in registers while those before run past them.
    Tile sums;
    for (int c = 0; c < kColumns; ++c) {
      sums.top[c] = load(packed + (first + c) * kRows);
      sums.bottom[c] = load(packed + (first + c) * kRows + kLanes);
    }
    for (int k = 0; k < first; ++k) {
      const Lanes top = load(packed + k * kRows), bottom = load(packed + k * kRows + kLanes);
      for (int c = 0; c < kColumns; ++c) {
        const double factor = lower[(first + c) * kPanel + k];
        sums.top[c] -= factor * top, sums.bottom[c] -= factor * bottom;
      }
    }
    // Within the four each column takes off those in front of it, and is divided by its pivot.
    for (int c = 0; c < kColumns && first + c < panel; ++c) {
      const double* const row = lower + (first + c) * kPanel + first;
      for (int k = 0; k < c; ++k) {
        sums.top[c] -= row[k] * sums.top[k], sums.bottom[c] -= row[k] * sums.bottom[k];
      }
      const double inverse = 1 / row[c];
      sums.top[c] *= inverse, sums.bottom[c] *= inverse;
      store(sums.top[c], packed + (first + c) * kRows);
      store(sums.bottom[c], packed + (first + c) * kRows + kLanes);
    }
  }

  // Each sum over the panel runs from its first column to its last.
  static void update_tile(double* a, int size, int panel, int num_rows, int num_columns, int above,
                          const double* rows, const double* columns) {
    // A tile of sums stays in registers while the panel runs past it.
    Tile sums = {};
    for (int k = 0; k < panel; ++k, rows += kRows, columns += kRows) {
      const Lanes top = load(rows), bottom = load(rows + kLanes);
      for (int c = 0; c < kColumns; ++c) {
        sums.top[c] += columns[c] * top;
        sums.bottom[c] += columns[c] * bottom;
      }
    }
    // Only a whole tile below the diagonal can be written by registers.
    if (num_rows == kRows && num_columns == kColumns && above + kColumns <= 1)
      subtract_whole(a, size, sums);
    else
      subtract_part(a, size, num_rows, num_columns, above, sums);
  }
  static void subtract_whole(double* a, int size, const Tile& sums) {
    for (int c = 0; c < kColumns; ++c, a += size) {
      store(load(a) - sums.top[c], a);
      store(load(a + kLanes) - sums.bottom[c], a + kLanes);
    }
  }
  static void subtract_part(double* a, int size, int num_rows, int num_columns, int above,
                            const Tile& sums) {
    for (int c = 0; c < num_columns; ++c, a += size)
      for (int i = above + c < 0 ? 0 : above + c; i < num_rows; ++i)
        a[i] -= i < kLanes ? sums.top[c][i] : sums.bottom[c][i - kLanes];
  }
};

}  // namespace trivet::flex
