#include "core/flex/dense_front.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/lanes.h"

namespace trivet::flex {
namespace {

constexpr int kPanel = 48;  // columns that are factored before the rest is updated
constexpr int kTile = 4;    // rows and columns of a tile whose sums are held in registers

/// A tile's sums over a panel, each from its first column to its last.
struct TileSums {
  Double2 top[kTile] = {}, bottom[kTile] = {};  // by columns

  // @param rows, columns  kTile numbers for each column of the panel.
  void run(const double* rows, const double* columns, int panel) {
    for (int k = 0; k < panel; ++k, rows += kTile, columns += kTile) {
      const Double2 upper{rows[0], rows[1]}, lower{rows[2], rows[3]};
      for (int j = 0; j < kTile; ++j) {
        const Double2 factor = both(columns[j]);
        top[j] += upper * factor;
        bottom[j] += lower * factor;
      }
    }
  }
  double at(int i, int j) const { return i < 2 ? top[j][i] : bottom[j][i - 2]; }
};

// Rows from `first` on of a panel's columns, kTile rows together, zeros at the end.
void pack(const double* a, int size, int first, int column, int panel, std::vector<double>& out) {
  const int num_tiles = (size - first + kTile - 1) / kTile;
  out.assign(static_cast<size_t>(num_tiles) * panel * kTile, 0);
  for (int t = 0; t < num_tiles; ++t)
    for (int k = 0; k < panel; ++k)
      for (int i = 0; i < std::min(kTile, size - first - t * kTile); ++i)
        out[(static_cast<size_t>(t) * panel + k) * kTile + i] =
            a[static_cast<size_t>(column + k) * size + first + t * kTile + i];
}

void subtract_tile(double* a, int size, int row, int column, const TileSums& sums) {
  for (int j = 0; j < std::min(kTile, size - column); ++j)
    for (int i = 0; i < std::min(kTile, size - row); ++i)
      if (row + i >= column + j)
        a[static_cast<size_t>(column + j) * size + row + i] -= sums.at(i, j);
}

// Subtracts L L' of a panel from the lower triangle behind it.
void update_rest(double* a, int size, int column, int panel, std::vector<double>& packed) {
  const int first = column + panel;
  pack(a, size, first, column, panel, packed);
  const int num_tiles = (size - first + kTile - 1) / kTile;
  const auto tile = [&](int t) { return packed.data() + static_cast<size_t>(t) * panel * kTile; };
  for (int j = 0; j < num_tiles; ++j)
    for (int i = j; i < num_tiles; ++i) {
      TileSums sums;
      sums.run(tile(i), tile(j), panel);
      subtract_tile(a, size, first + i * kTile, first + j * kTile, sums);
    }
}

// The columns of a panel, one after another, over all rows below.
bool factor_panel(double* a, int size, int column, int panel) {
  for (int j = column; j < column + panel; ++j) {
    double* const own = a + static_cast<size_t>(j) * size;
    for (int k = column; k < j; ++k) {
      const double* const before = a + static_cast<size_t>(k) * size;
      const double factor = before[j];
      for (int i = j; i < size; ++i) own[i] -= factor * before[i];
    }
    if (!(own[j] > 0) || !std::isfinite(own[j])) return false;
    own[j] = std::sqrt(own[j]);
    const double inverse = 1 / own[j];
    for (int i = j + 1; i < size; ++i) own[i] *= inverse;
  }
  return true;
}

}  // namespace

bool factor_front(double* a, int size, int num_own) {
  std::vector<double> packed;
  for (int column = 0; column < num_own; column += kPanel) {
    const int panel = std::min(kPanel, num_own - column);
    if (!factor_panel(a, size, column, panel)) return false;
    if (column + panel < size) update_rest(a, size, column, panel, packed);
  }
  return true;
}

void solve_forward(const double* a, int size, int num_own, double* x, double* below) {
  for (int k = 0; k < num_own; ++k) {
    const double* const column = a + static_cast<size_t>(k) * size;
    x[k] /= column[k];
    for (int i = k + 1; i < num_own; ++i) x[i] -= column[i] * x[k];
    for (int i = num_own; i < size; ++i) below[i - num_own] -= column[i] * x[k];
  }
}

void solve_backward(const double* a, int size, int num_own, double* x, const double* below) {
  for (int k = num_own - 1; k >= 0; --k) {
    const double* const column = a + static_cast<size_t>(k) * size;
    double sum = x[k];
    for (int i = k + 1; i < num_own; ++i) sum -= column[i] * x[i];
    for (int i = num_own; i < size; ++i) sum -= column[i] * below[i - num_own];
    x[k] = sum / column[k];
  }
}

}  // namespace trivet::flex
