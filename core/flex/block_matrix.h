// Symmetric sparse matrices of 3 x 3 blocks.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace trivet::flex {

/// Row i holds the blocks (i, j) that were added, of both triangles, in the order of their
/// addition.
class BlockMatrix {
 public:
  struct Block {
    int column;
    Mat3 values;
  };

  /// Empties it, keeping memory.
  void reset(size_t num_rows) {
    m_rows.resize(num_rows);
    for (auto& row : m_rows) row.clear();
  }
  void add(int row, int column, const Mat3& values) {
    for (Block& block : m_rows[row])
      if (block.column == column) {
        block.values += values;
        return;
      }
    m_rows[row].push_back({column, values});
  }
  /// Adds to the block (i, j) and its transpose to (j, i); i != j.
  void add_both(int i, int j, const Mat3& values) {
    add(i, j, values);
    add(j, i, values.transpose());
  }
  Mat3* find(int row, int column) {
    for (Block& block : m_rows[row])
      if (block.column == column) return &block.values;
    return nullptr;
  }
  size_t num_rows() const { return m_rows.size(); }
  const std::vector<Block>& row(size_t i) const { return m_rows[i]; }
  /// The same matrix but for row and column i, which become `diagonal` times those of the identity.
  void pin(int i, double diagonal) {
    for (Block& block : m_rows[i]) {
      if (block.column != i) find(block.column, i)->setZero();
      block.values.setZero();
      if (block.column == i) block.values.diagonal().setConstant(diagonal);
    }
  }

 private:
  std::vector<std::vector<Block>> m_rows;
};

}  // namespace trivet::flex
