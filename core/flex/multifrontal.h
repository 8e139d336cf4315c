// Sparse Cholesky factorisation on 3 x 3 blocks by fronts [Duff and Reid 1983], ordered by nested
// dissection [George 1973].
#pragma once

#include <span>
#include <vector>

#include "core/flex/block_matrix.h"

namespace trivet::flex {

/// Each cut of the dissection is the median along the coordinate that gives the smallest separator
/// of the real graph: contact between far parts of a sheet needs no special case. Each front is
/// computed by one thread, and children are added in a fixed order: the same bits for any number of
/// threads.
class Multifrontal {
 public:
  /// Coordinates of the vertices, by which cuts may be made.
  using Coordinates = std::vector<std::vector<double>>;

  void analyse(const BlockMatrix& a, const Coordinates& coordinates);
  /// True if the analysed pattern holds every block of `a`.
  bool covers(const BlockMatrix& a) const;
  /// @return false if `a`, which is covered, is not positive definite.
  bool factor(const BlockMatrix& a);
  /// In place, after factor(). @param x  of the vertices.
  void solve(std::vector<Vec3>& x) const;

 private:
  struct Front {
    std::vector<int> own, below, children;  // vertices; those below are sorted by position
    size_t lower = 0;                       // place of its columns of L
    std::vector<double> update;             // for its parent: the lower triangle, column by column
    int size() const { return 3 * static_cast<int>(own.size() + below.size()); }
  };
  /// The memory that a thread works in.
  struct Work {
    std::vector<int> local;      // places of vertices in the front
    std::vector<double> values;  // the front, of which the lower triangle counts
    std::vector<int> places;     // of a child's vertices
  };
  class WorkPool;
  struct Cut {
    std::vector<int> left, right, separator;
  };

  int dissect(const BlockMatrix& a, const Coordinates& coordinates, std::vector<int> list);
  Cut cut(const BlockMatrix& a, const std::vector<double>& coordinate, std::vector<int>& list);
  Cut smallest_cut(const BlockMatrix& a, const Coordinates& coordinates, std::vector<int>& list);
  int add_front(std::vector<int> own, std::vector<int> children);
  void find_below(const BlockMatrix& a);
  void find_subtrees();
  void place_columns();
  bool compute_subtree(const BlockMatrix& a, int id, WorkPool& pool);
  bool compute(const BlockMatrix& a, int id, Work& work);
  void add_own(const BlockMatrix& a, const Front& front, Work& work) const;
  void keep(Front& front, const Work& work);

  std::vector<Front> m_fronts;  // children before parents
  std::vector<int> m_position;  // of the vertices in the elimination
  std::vector<int> m_mark;
  int m_stamp = 0, m_next = 0;
  std::vector<std::vector<int>> m_pattern;  // sorted
  struct Subtree {
    int first = 0, size = 0;  // its first front, and its vertices
  };
  std::vector<Subtree> m_subtrees;  // below each front
  std::vector<double> m_lower;      // L, front by front
};

}  // namespace trivet::flex
