#include "core/flex/multifrontal.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <numeric>

#include "core/base/in_parallel.h"
#include "core/flex/dense_front.h"

namespace trivet::flex {
namespace {

constexpr size_t kLeaf = 24;        // vertices that are not dissected
constexpr int kTaskVertices = 800;  // of a subtree that one thread computes
// Fronts from so many rows on are copied by several threads, so many columns by each.
constexpr int kManyRows = 400, kColumnsTogether = 64;

// Its memory, too: an assignment of {} would keep that.
void release(std::vector<double>& values) { std::vector<double>().swap(values); }

}  // namespace

int Multifrontal::add_front(std::vector<int> own, std::vector<int> children) {
  for (const int v : own) m_position[v] = m_next++;
  m_fronts.push_back({std::move(own), {}, std::move(children), 0, {}});
  return static_cast<int>(m_fronts.size()) - 1;
}

// The separator is on the side where fewer vertices have neighbours on the other.
Multifrontal::Cut Multifrontal::cut(const BlockMatrix& a, const std::vector<double>& coordinate,
                                    std::vector<int>& list) {
  // The median along a coordinate halves the vertices, ties by number.
  const size_t half = list.size() / 2;
  const auto less = [&](int x, int y) {
    return coordinate[x] != coordinate[y] ? coordinate[x] < coordinate[y] : x < y;
  };
  std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(half), list.end(),
                   less);
  // Stamps mark sides without clearing the marks of earlier cuts.
  const int left = ++m_stamp, right = ++m_stamp;
  for (size_t i = 0; i < list.size(); ++i) m_mark[list[i]] = i < half ? left : right;
  // A vertex touches the other side if one of its blocks does.
  const auto touches = [&](int v) {
    const int other = m_mark[v] == left ? right : left;
    return std::any_of(a.row(v).begin(), a.row(v).end(),
                       [&](const BlockMatrix::Block& b) { return m_mark[b.column] == other; });
  };
  std::vector<int> sides[2], touching[2];
  for (size_t i = 0; i < list.size(); ++i) {
    sides[i >= half].push_back(list[i]);
    if (touches(list[i])) touching[i >= half].push_back(list[i]);
  }
  // The smaller of both touching sets separates as well, and makes the smaller front.
  const int side = touching[0].size() <= touching[1].size() ? 0 : 1;
  const int in = ++m_stamp;
  for (const int v : touching[side]) m_mark[v] = in;
  for (auto& vertices : sides) std::erase_if(vertices, [&](int v) { return m_mark[v] == in; });
  for (auto* vertices : {&sides[0], &sides[1], &touching[side]})
    std::sort(vertices->begin(), vertices->end());
  return {std::move(sides[0]), std::move(sides[1]), std::move(touching[side])};
}

Multifrontal::Cut Multifrontal::smallest_cut(const BlockMatrix& a, const Coordinates& coordinates,
                                             std::vector<int>& list) {
  Cut best;
  // Rest shape and present positions give different cuts; the smallest separator wins.
  for (const auto& coordinate : coordinates) {
    Cut one = cut(a, coordinate, list);
    const bool is_first = &coordinate == &coordinates.front();
    if (is_first || one.separator.size() < best.separator.size()) best = std::move(one);
  }
  return best;
}

int Multifrontal::dissect(const BlockMatrix& a, const Coordinates& coordinates,
                          std::vector<int> list) {
  if (list.size() <= kLeaf) return add_front(std::move(list), {});
  Cut best = smallest_cut(a, coordinates, list);
  // A separator as large as half the set would gain nothing: the rest is one front.
  if (best.left.empty() || best.right.empty() || 2 * best.separator.size() > list.size())
    return add_front(std::move(list), {});
  list.clear();
  const int first = dissect(a, coordinates, std::move(best.left));
  const int second = dissect(a, coordinates, std::move(best.right));
  if (!best.separator.empty()) return add_front(std::move(best.separator), {first, second});
  m_fronts[second].children.push_back(first);  // parts without connection
  return second;
}

void Multifrontal::find_below(const BlockMatrix& a) {
  const auto before = [&](int x, int y) { return m_position[x] < m_position[y]; };
  // A front reaches the later vertices that its own columns touch, and those that its children
  // leave over.
  for (Front& front : m_fronts) {
    const int last = m_position[front.own.back()];
    std::vector<int>& below = front.below;
    for (const int v : front.own)
      for (const auto& block : a.row(v))
        if (m_position[block.column] > last) below.push_back(block.column);
    for (const int child : front.children)
      for (const int v : m_fronts[child].below)
        if (m_position[v] > last) below.push_back(v);
    std::sort(below.begin(), below.end(), before);
    below.erase(std::unique(below.begin(), below.end()), below.end());
  }
}

// Fronts are numbered depth-first, so that those of a subtree are consecutive.
void Multifrontal::find_subtrees() {
  m_subtrees.assign(m_fronts.size(), {});
  for (size_t i = 0; i < m_fronts.size(); ++i) {
    Subtree& subtree = m_subtrees[i];
    subtree = {static_cast<int>(i), static_cast<int>(m_fronts[i].own.size())};
    for (const int child : m_fronts[i].children) {
      subtree.first = std::min(subtree.first, m_subtrees[child].first);
      subtree.size += m_subtrees[child].size;
    }
  }
}

void Multifrontal::place_columns() {
  size_t next = 0;
  for (Front& front : m_fronts) {
    front.lower = next;
    next += static_cast<size_t>(front.size()) * 3 * front.own.size();
  }
  m_lower.resize(next);
}

void Multifrontal::analyse(const BlockMatrix& a, const Coordinates& coordinates) {
  const size_t count = a.num_rows();
  m_fronts.clear();
  release(m_lower);  // old and new are never there together
  m_position.assign(count, -1);
  m_mark.assign(count, 0);
  m_stamp = m_next = 0;
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  // Vertices are numbered from the leaves of the dissection to its root, as elimination goes.
  dissect(a, coordinates, std::move(all));
  find_below(a);
  find_subtrees();
  place_columns();
  // The pattern is kept: matrices within it need no new analysis.
  m_pattern.assign(count, {});
  for (size_t i = 0; i < count; ++i) {
    for (const auto& block : a.row(i)) m_pattern[i].push_back(block.column);
    std::sort(m_pattern[i].begin(), m_pattern[i].end());
  }
}

bool Multifrontal::covers(const BlockMatrix& a) const {
  if (a.num_rows() != m_pattern.size()) return false;
  for (size_t i = 0; i < m_pattern.size(); ++i)
    for (const auto& block : a.row(i))
      if (!std::binary_search(m_pattern[i].begin(), m_pattern[i].end(), block.column)) return false;
  return true;
}

namespace {

// f(j) of all columns of a front: by several threads if it is large.
template <class F>
void for_columns(int count, int size, F f) {
  const auto run = [&](int first, int last) {
    for (int j = first; j < last; ++j) f(j);
  };
  if (size < kManyRows) return run(0, count);
  in_parallel((count + kColumnsTogether - 1) / kColumnsTogether, [&](size_t piece) {
    const int first = static_cast<int>(piece) * kColumnsTogether;
    run(first, std::min(count, first + kColumnsTogether));
  });
}

// The place of the first element of a column in a packed lower triangle.
size_t packed_column(size_t size, size_t j) { return j * size - j * (j - 1) / 2; }

// The vertices come in the order of the parent's: an element below the diagonal stays below it.
void add_update(const std::vector<double>& update, const std::vector<int>& places, double* values,
                int size) {
  const int count = 3 * static_cast<int>(places.size());
  for_columns(count, size, [&](int column) {
    const int j = column / 3, c = column % 3;
    const double* from = update.data() + packed_column(count, column);
    double* const to = values + static_cast<size_t>(places[j] + c) * size;
    // The block on the diagonal is kept in its lower half alone.
    for (int r = c; r < 3; ++r) to[places[j] + r] += *from++;
    for (size_t i = j + 1; i < places.size(); ++i, from += 3) {
      double* const row = to + places[i];
      row[0] += from[0], row[1] += from[1], row[2] += from[2];
    }
  });
}

}  // namespace

// Own rows come from the matrix; each pair of vertices once, in the earlier one's front.
void Multifrontal::add_own(const BlockMatrix& a, const Front& front, Work& work) const {
  const int size = front.size();
  for (size_t i = 0; i < front.own.size(); ++i) {
    const int position = m_position[front.own[i]];
    for (const auto& block : a.row(front.own[i])) {
      if (m_position[block.column] < position) continue;
      double* const to = work.values.data() + 3 * i * size + 3 * work.local[block.column];
      for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) to[static_cast<size_t>(c) * size + r] += block.values(c, r);
    }
  }
}

// L for good, the rest until the parent has it.
void Multifrontal::keep(Front& front, const Work& work) {
  const int size = front.size(), num_own = 3 * static_cast<int>(front.own.size());
  const int left = size - num_own;
  front.update.resize(packed_column(left, left));
  for_columns(size, size, [&](int j) {
    const double* const column = work.values.data() + static_cast<size_t>(j) * size;
    double* const to = j < num_own
                           ? m_lower.data() + front.lower + static_cast<size_t>(j) * size + j
                           : front.update.data() + packed_column(left, j - num_own);
    std::copy(column + j, column + size, to);
  });
}

bool Multifrontal::compute(const BlockMatrix& a, int id, Work& work) {
  Front& front = m_fronts[id];
  const int num_own = static_cast<int>(front.own.size()), size = front.size();
  // Places of vertices in this front are looked up by a table of the thread.
  for (int i = 0; i < num_own; ++i) work.local[front.own[i]] = i;
  for (size_t i = 0; i < front.below.size(); ++i)
    work.local[front.below[i]] = num_own + static_cast<int>(i);
  if (work.values.size() < static_cast<size_t>(size) * size)
    work.values.resize(static_cast<size_t>(size) * size);
  double* const values = work.values.data();
  for_columns(size, size, [&](int j) {
    std::fill_n(values + static_cast<size_t>(j) * (size + 1), size - j, 0.0);
  });
  add_own(a, front, work);
  // Children add what they leave, and then this front's columns are eliminated.
  for (const int id_of_child : front.children) {
    Front& child = m_fronts[id_of_child];
    work.places.clear();
    for (const int v : child.below) work.places.push_back(3 * work.local[v]);
    add_update(child.update, work.places, values, size);
    release(child.update);
  }
  if (!factor_front(values, size, 3 * num_own)) return false;
  keep(front, work);
  return true;
}

// A thread takes what another one has given back.
class Multifrontal::WorkPool {
 public:
  explicit WorkPool(size_t num_vertices) : m_num_vertices(num_vertices) {}

  std::unique_ptr<Work> take() {
    const std::lock_guard lock(m_mutex);
    if (m_free.empty())
      return std::make_unique<Work>(Work{std::vector<int>(m_num_vertices), {}, {}});
    std::unique_ptr<Work> out = std::move(m_free.back());
    m_free.pop_back();
    return out;
  }
  void give(std::unique_ptr<Work> work) {
    const std::lock_guard lock(m_mutex);
    m_free.push_back(std::move(work));
  }

 private:
  size_t m_num_vertices;
  std::mutex m_mutex;
  std::vector<std::unique_ptr<Work>> m_free;
};

// Subtrees share no vertex, so that threads need no locks, and sums keep their order.
bool Multifrontal::compute_subtree(const BlockMatrix& a, int id, WorkPool& pool) {
  const bool is_small = m_subtrees[id].size <= kTaskVertices;
  std::atomic<bool> is_definite = true;
  const std::vector<int>& children = m_fronts[id].children;
  // Depth-first, so that few fronts wait for their parents.
  if (!is_small)
    in_parallel(children.size(), [&](size_t i) {
      if (!compute_subtree(a, children[i], pool)) is_definite = false;
    });
  if (!is_definite) return false;
  std::unique_ptr<Work> work = pool.take();
  for (int i = is_small ? m_subtrees[id].first : id; i <= id && is_definite; ++i)
    if (!compute(a, i, *work)) is_definite = false;
  pool.give(std::move(work));
  return is_definite;
}

bool Multifrontal::factor(const BlockMatrix& a) {
  for (Front& front : m_fronts) release(front.update);  // a failure leaves some
  WorkPool pool(m_position.size());
  return m_fronts.empty() || compute_subtree(a, static_cast<int>(m_fronts.size()) - 1, pool);
}

void Multifrontal::solve(std::vector<Vec3>& x) const {
  std::vector<double> values;
  // Entries of a front are gathered, solved, and put back: down for L, up for its transpose.
  const auto gather = [&](const Front& front) {
    values.clear();
    for (const auto* vertices : {&front.own, &front.below})
      for (const int v : *vertices) values.insert(values.end(), {x[v][0], x[v][1], x[v][2]});
  };
  const auto scatter = [&](const std::vector<int>& vertices, const double* from) {
    for (const int v : vertices) {
      x[v] = Vec3(from[0], from[1], from[2]);
      from += 3;
    }
  };
  for (const Front& front : m_fronts) {
    gather(front);
    const int num_own = 3 * static_cast<int>(front.own.size());
    solve_forward(m_lower.data() + front.lower, front.size(), num_own, values.data());
    scatter(front.own, values.data());
    scatter(front.below, values.data() + num_own);
  }
  for (size_t i = m_fronts.size(); i-- > 0;) {
    const Front& front = m_fronts[i];
    gather(front);
    const int num_own = 3 * static_cast<int>(front.own.size());
    solve_backward(m_lower.data() + front.lower, front.size(), num_own, values.data());
    scatter(front.own, values.data());
  }
}

}  // namespace trivet::flex
