// Cholesky's factors of a symmetric positive definite matrix of blocks. Private.
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Blocks are couplings of nodes. Nodes are eliminated in the order of least degree [Tinney 1967],
/// of equal ones the first; what a pivot leaves of the size of rounding counts as infinite, so that
/// its unknown is zero. Cost O(nodes x (coupled nodes)^2).
class BlockFactor {
 public:
  static constexpr int kRows = 8;  // of a node
  using Block = Eigen::Matrix<double, kRows, kRows>;
  using Rows = Eigen::Matrix<double, kRows, 1>;

  /// @param couplings  pairs of different nodes, in any order, also twice.
  BlockFactor(size_t num_nodes, std::span<const std::pair<Index, Index>> couplings);

  void set_zero();
  /// Adds to the block of rows `a` and columns `b`, and its transpose to that of `b` and `a`; of a
  /// node with itself once. Only blocks that are coupled.
  void add(Index a, Index b, const Block& block);
  void factorise();
  /// x with matrix x = b, in place.
  void solve(std::vector<Rows>& b) const;

 private:
  size_t at(Index row, Index column) const { return row * m_columns.size() + column; }
  void find_order(std::vector<std::vector<char>> coupled);

  std::vector<Index> m_place;                 // of a node, in the order of elimination
  std::vector<std::vector<Index>> m_columns;  // by place: rows below the diagonal, ascending
  std::vector<Index> m_block_at;              // by place of row and column; -1: zero
  std::vector<Block> m_blocks;                // the first ones are the diagonal
};

}  // namespace trivet
