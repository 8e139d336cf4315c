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
    std::vector<double> values;             // L in the first columns
    int size() const { return 3 * static_cast<int>(own.size() + below.size()); }
  };
  struct Cut {
    std::vector<int> left, right, separator;
  };

  int dissect(const BlockMatrix& a, const Coordinates& coordinates, std::vector<int> list);
  Cut cut(const BlockMatrix& a, const std::vector<double>& coordinate, std::vector<int>& list);
  Cut smallest_cut(const BlockMatrix& a, const Coordinates& coordinates, std::vector<int>& list);
  int add_front(std::vector<int> own, std::vector<int> children);
  void find_below(const BlockMatrix& a);
  void find_tasks();
  bool compute(const BlockMatrix& a, int id, std::vector<int>& local);
  void add_child(Front& front, Front& child, const std::vector<int>& local) const;

  std::vector<Front> m_fronts;  // children before parents
  std::vector<int> m_position;  // of the vertices in the elimination
  std::vector<int> m_mark;
  int m_stamp = 0, m_next = 0;
  std::vector<std::vector<int>> m_pattern;   // sorted
  std::vector<std::pair<int, int>> m_tasks;  // first and last front of subtrees, for the threads
  std::vector<int> m_top;                    // the other fronts
};

}  // namespace trivet::flex
