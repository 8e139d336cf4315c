#include "core/flex/dense_front.h"

#include <algorithm>

#include "core/base/in_parallel.h"
#include "core/base/lanes.h"
#include "core/flex/dense_tiles.h"

namespace trivet::flex {
namespace {

constexpr int kBlock = 96;         // rows and columns that one thread updates together
constexpr int kManyThreads = 400;  // rows from which several threads pay

constexpr size_t square(int i) { return static_cast<size_t>(i) * i; }

/// The rows below a panel's square block.
class Rest {
 public:
  Rest(double* a, int size, int column, int panel, const DenseKernels& kernels)
      : m_kernels(kernels),
        m_a(a),
        m_size(size),
        m_column(column),
        m_panel(panel),
        m_first(column + panel) {}

  void divide(const std::vector<double>& lower, std::vector<double>& packed) {
    const int tile = m_kernels.rows, count = m_size - m_first;
    // Packed rows lie side by side as the tiles read them; zeros fill the last tile.
    packed.assign(static_cast<size_t>((count + tile - 1) / tile) * tile * kPanel, 0);
    m_packed = packed.data();
    // Rows do not depend on each other: blocks of them are divided in parallel.
    for_all((count + kBlock - 1) / kBlock, [&](int block) {
      for (int row = block * kBlock; row < std::min(count, (block + 1) * kBlock); row += tile)
        m_kernels.divide_rows(at(m_column, m_first + row), m_size, m_panel,
                              std::min(tile, count - row), lower.data(), packed_row(row));
    });
  }

  // Subtracts L L' from the lower triangle.
  void update() {
    // Blocks below the diagonal suffice, as the matrix is symmetric; they are numbered row by row.
    const int blocks = (m_size - m_first + kBlock - 1) / kBlock;
    for_all(blocks * (blocks + 1) / 2, [&](int number) {
      int i = 0;
      while ((i + 1) * (i + 2) / 2 <= number) ++i;
      update_block(i, number - i * (i + 1) / 2);
    });
  }

 private:
  template <class F>
  void for_all(int count, F f) const {
    // Small fronts are done before other threads would have begun.
    if (m_size - m_first < kManyThreads)
      for (int i = 0; i < count; ++i) f(i);
    else
      in_parallel(count, [&](size_t i) { f(static_cast<int>(i)); });
  }
  double* at(int column, int row) { return m_a + static_cast<size_t>(column) * m_size + row; }
  double* packed_row(int row) {
    return m_packed + static_cast<size_t>(row / m_kernels.rows) * m_kernels.rows * kPanel +
           row % m_kernels.rows;
  }
  void update_block(int i, int j) {
    const int count = m_size - m_first, tile = m_kernels.rows;
    // Tiles begin at the diagonal: the part above it is never read.
    for (int column = j * kBlock; column < std::min(count, (j + 1) * kBlock); column += 4)
      for (int row = std::max(i * kBlock, column / tile * tile);
           row < std::min(count, (i + 1) * kBlock); row += tile)
        m_kernels.update_tile(at(m_first + column, m_first + row), m_size, m_panel,
                              std::min(tile, count - row), std::min(4, count - column),
                              column - row, packed_row(row), packed_row(column));
  }

  const DenseKernels& m_kernels;
  double *m_a, *m_packed = nullptr;
  int m_size, m_column, m_panel, m_first;
};

}  // namespace

constinit const DenseKernels kKernelsOfTwo = DenseTiles<Double2>::kernels();

const std::vector<const DenseKernels*>& usable_kernels() {
  static const std::vector<const DenseKernels*> usable = [] {
    // The widest registers come first.
    std::vector<const DenseKernels*> out;
#ifdef TRIVET_WIDE_KERNELS
    if (__builtin_cpu_supports("avx512f")) out.push_back(&kKernelsOfEight);
    if (__builtin_cpu_supports("avx2")) out.push_back(&kKernelsOfFour);
#endif
    out.push_back(&kKernelsOfTwo);
    return out;
  }();
  return usable;
}

bool factor_front(double* a, int size, int num_own, const DenseKernels& kernels) {
  std::vector<double> packed, lower;
  for (int column = 0; column < num_own; column += kPanel) {
    // Each panel is factored, and then subtracted from all behind it at once, which caches like.
    const int panel = std::min(kPanel, num_own - column);
    lower.assign(square(kPanel), 0);
    double* const block = a + static_cast<size_t>(column) * (size + 1);
    if (!kernels.factor_block(block, size, panel, lower.data())) return false;
    Rest rest(a, size, column, panel, kernels);
    rest.divide(lower, packed);
    rest.update();
  }
  return true;
}

void solve_forward(const double* a, int size, int num_own, double* x, const DenseKernels& kernels) {
  // Columns go from the first to the last: each is solved before it is taken off those below.
  for (int k = 0; k < num_own; ++k) {
    const double* const column = a + static_cast<size_t>(k) * size;
    x[k] /= column[k];
    kernels.subtract(x + k + 1, column + k + 1, x[k], size - k - 1);
  }
}

void solve_backward(const double* a, int size, int num_own, double* x,
                    const DenseKernels& kernels) {
  // The transpose goes the other way: each entry takes off what is solved behind it.
  for (int k = num_own - 1; k >= 0; --k) {
    const double* const column = a + static_cast<size_t>(k) * size;
    x[k] = (x[k] - kernels.product(column + k + 1, x + k + 1, size - k - 1)) / column[k];
  }
}

}  // namespace trivet::flex
