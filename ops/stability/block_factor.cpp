#include "ops/stability/block_factor.h"

#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

using FactorBlock = BlockFactor::Block;
constexpr int kBlockRows = BlockFactor::kRows;

constexpr double kPivotRounding = 1e-14;  // of a pivot's size before
constexpr double kInfinitePivot = 1e64;

// The lower factor, in place.
void factorise_diagonal(FactorBlock& a) {
  for (int k = 0; k < kBlockRows; ++k) {
    const double before = a(k, k);
    double pivot = before - a.row(k).head(k).squaredNorm();
    if (!(pivot > kPivotRounding * before)) pivot = kInfinitePivot;
    const double root = std::sqrt(pivot);
    a(k, k) = root;
    for (int i = k + 1; i < kBlockRows; ++i) {
      double sum = a(i, k);
      for (int j = 0; j < k; ++j) sum -= a(i, j) * a(k, j);
      a(i, k) = sum / root;
    }
    for (int i = 0; i < k; ++i) a(i, k) = 0;
  }
}

// a L^-T, in place, column by column.
void divide_by_lower(const FactorBlock& lower, FactorBlock& a) {
  for (int k = 0; k < kBlockRows; ++k) {
    for (int j = 0; j < k; ++j) a.col(k) -= lower(k, j) * a.col(j);
    a.col(k) /= lower(k, k);
  }
}

// to -= a b^T
void subtract_product(const FactorBlock& a, const FactorBlock& b, FactorBlock& to) {
  for (int c = 0; c < kBlockRows; ++c) {
    BlockFactor::Rows sum = to.col(c);
    for (int k = 0; k < kBlockRows; ++k) sum -= b(c, k) * a.col(k);
    to.col(c) = sum;
  }
}

}  // namespace

BlockFactor::BlockFactor(size_t num_nodes, std::span<const std::pair<Index, Index>> couplings)
    : m_place(num_nodes), m_columns(num_nodes), m_block_at(num_nodes * num_nodes, -1) {
  std::vector<std::vector<char>> coupled(num_nodes, std::vector<char>(num_nodes, 0));
  for (const auto& [a, b] : couplings) coupled[a][b] = coupled[b][a] = 1;
  find_order(std::move(coupled));
  Index num_blocks = 0;
  for (size_t k = 0; k < num_nodes; ++k) m_block_at[at(k, k)] = num_blocks++;
  for (size_t k = 0; k < num_nodes; ++k)
    for (const Index row : m_columns[k]) m_block_at[at(row, k)] = num_blocks++;
  m_blocks.resize(num_blocks);
}

// Neighbours of an eliminated node become coupled with each other.
void BlockFactor::find_order(std::vector<std::vector<char>> coupled) {
  const size_t n = m_place.size();
  std::vector<char> is_done(n, 0);
  std::vector<std::vector<Index>> left(n);  // nodes of each column
  for (size_t place = 0; place < n; ++place) {
    size_t best = n, least = n + 1;
    for (size_t i = 0; i < n; ++i) {
      if (is_done[i]) continue;
      const auto degree = static_cast<size_t>(std::count(coupled[i].begin(), coupled[i].end(), 1));
      if (degree < least) best = i, least = degree;
    }
    is_done[best] = 1;
    m_place[best] = static_cast<Index>(place);
    std::vector<Index>& column = left[place];
    for (size_t i = 0; i < n; ++i)
      if (coupled[best][i]) column.push_back(static_cast<Index>(i)), coupled[i][best] = 0;
    for (const Index a : column)
      for (const Index b : column)
        if (a != b) coupled[a][b] = 1;
  }
  for (size_t place = 0; place < n; ++place) {
    for (const Index node : left[place]) m_columns[place].push_back(m_place[node]);
    std::sort(m_columns[place].begin(), m_columns[place].end());
  }
}

void BlockFactor::set_zero() {
  for (Block& block : m_blocks) block.setZero();
}

void BlockFactor::add(Index a, Index b, const Block& block) {
  const Index row = m_place[a], column = m_place[b];
  if (row >= column)
    m_blocks[m_block_at[at(row, column)]] += block;
  else
    m_blocks[m_block_at[at(column, row)]] += block.transpose();
}

void BlockFactor::factorise() {
  for (size_t k = 0; k < m_columns.size(); ++k) {
    const Block& diagonal = m_blocks[k];
    factorise_diagonal(m_blocks[k]);
    const std::vector<Index>& rows = m_columns[k];
    for (const Index row : rows) divide_by_lower(diagonal, m_blocks[m_block_at[at(row, k)]]);
    for (size_t j = 0; j < rows.size(); ++j) {
      const Block& column = m_blocks[m_block_at[at(rows[j], k)]];
      for (size_t i = j; i < rows.size(); ++i)
        subtract_product(m_blocks[m_block_at[at(rows[i], k)]], column,
                         m_blocks[m_block_at[at(rows[i], rows[j])]]);
    }
  }
}

void BlockFactor::solve(std::vector<Rows>& b) const {
  std::vector<Rows> x(b.size());
  for (size_t i = 0; i < b.size(); ++i) x[m_place[i]] = b[i];
  // Down with the lower factor, up with its transpose.
  for (size_t k = 0; k < x.size(); ++k) {
    m_blocks[k].triangularView<Eigen::Lower>().solveInPlace(x[k]);
    for (const Index row : m_columns[k])
      x[row] -= m_blocks[m_block_at[at(row, k)]].lazyProduct(x[k]);
  }
  for (size_t k = x.size(); k-- > 0;) {
    for (const Index row : m_columns[k])
      x[k] -= m_blocks[m_block_at[at(row, k)]].transpose().lazyProduct(x[row]);
    m_blocks[k].transpose().triangularView<Eigen::Upper>().solveInPlace(x[k]);
  }
  for (size_t i = 0; i < b.size(); ++i) b[i] = x[m_place[i]];
}

}  // namespace trivet
