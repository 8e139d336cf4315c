#include "core/flex/multifrontal.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "core/base/in_parallel.h"
#include "core/flex/dense_front.h"

namespace trivet::flex {
namespace {

constexpr size_t kLeaf = 24;        // vertices that are not dissected
constexpr int kTaskVertices = 200;  // of a subtree that one thread computes

}  // namespace

int Multifrontal::add_front(std::vector<int> own, std::vector<int> children) {
  for (const int v : own) m_position[v] = m_next++;
  m_fronts.push_back({std::move(own), {}, std::move(children), {}});
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
void Multifrontal::find_tasks() {
  const size_t count = m_fronts.size();
  // Sizes of subtrees tell which are small enough for one thread each.
  std::vector<int> size(count), first(count), parent(count, -1);
  for (size_t i = 0; i < count; ++i) {
    size[i] = static_cast<int>(m_fronts[i].own.size());
    first[i] = static_cast<int>(i);
    for (const int child : m_fronts[i].children) {
      size[i] += size[child];
      first[i] = std::min(first[i], first[child]);
      parent[child] = static_cast<int>(i);
    }
  }
  m_tasks.clear();
  m_top.clear();
  // The largest subtrees below the limit are tasks; all above them runs in order at the end.
  for (size_t i = 0; i < count; ++i) {
    const bool is_small = size[i] <= kTaskVertices;
    if (!is_small) m_top.push_back(static_cast<int>(i));
    if (is_small && (parent[i] < 0 || size[parent[i]] > kTaskVertices))
      m_tasks.emplace_back(first[i], static_cast<int>(i));
  }
}

void Multifrontal::analyse(const BlockMatrix& a, const Coordinates& coordinates) {
  const size_t count = a.num_rows();
  m_fronts.clear();
  m_position.assign(count, -1);
  m_mark.assign(count, 0);
  m_stamp = m_next = 0;
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  // Vertices are numbered from the leaves of the dissection to its root, as elimination goes.
  dissect(a, coordinates, std::move(all));
  find_below(a);
  find_tasks();
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

// Adds what a child leaves to the vertices below it, which are among those of its parent, in the
// same order.
void Multifrontal::add_child(Front& front, Front& child, const std::vector<int>& local) const {
  const int size = front.size(), child_size = child.size(), num_below = child_size / 3;
  const int first = static_cast<int>(child.own.size());
  // The child's vertices come in the order of the parent's: an element below the diagonal stays
  // below it.
  const auto place = [&](int vertex) { return 3 * local[child.below[vertex - first]]; };
  for (int j = first; j < num_below; ++j)
    for (int c = 0; c < 3; ++c) {
      double* const to = front.values.data() + static_cast<size_t>(place(j) + c) * size;
      const double* const from = child.values.data() + static_cast<size_t>(3 * j + c) * child_size;
      // The block on the diagonal is kept in its lower half alone.
      for (int r = c; r < 3; ++r) to[place(j) + r] += from[3 * j + r];
      for (int i = j + 1; i < num_below; ++i)
        for (int r = 0; r < 3; ++r) to[place(i) + r] += from[3 * i + r];
    }
}

bool Multifrontal::compute(const BlockMatrix& a, int id, std::vector<int>& local) {
  Front& front = m_fronts[id];
  const int num_own = static_cast<int>(front.own.size()), size = front.size();
  // Places of vertices in this front are looked up by a table of the thread.
  for (int i = 0; i < num_own; ++i) local[front.own[i]] = i;
  for (size_t i = 0; i < front.below.size(); ++i)
    local[front.below[i]] = num_own + static_cast<int>(i);
  front.values.assign(static_cast<size_t>(size) * size, 0);
  // Own rows come from the matrix; each pair of vertices once, in the earlier one's front.
  for (int i = 0; i < num_own; ++i)
    for (const auto& block : a.row(front.own[i])) {
      const int j = local[block.column];
      if (m_position[block.column] < m_position[front.own[i]]) continue;
      for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
          front.values[static_cast<size_t>(3 * i + c) * size + 3 * j + r] += block.values(c, r);
    }
  // Children add what they leave, and then this front's columns are eliminated.
  for (const int child : front.children) add_child(front, m_fronts[child], local);
  if (!factor_front(front.values.data(), size, 3 * num_own)) return false;
  for (const int child : front.children) {  // only L is needed from here on
    Front& done = m_fronts[child];
    done.values.resize(static_cast<size_t>(done.size()) * 3 * done.own.size());
    done.values.shrink_to_fit();
  }
  return true;
}

bool Multifrontal::factor(const BlockMatrix& a) {
  std::atomic<bool> is_definite = true;
  // Subtrees share no vertex, so that threads need no locks, and sums keep their order.
  const auto run_task = [&](size_t task) {
    std::vector<int> local(m_position.size());
    for (int i = m_tasks[task].first; i <= m_tasks[task].second && is_definite; ++i)
      if (!compute(a, i, local)) is_definite = false;
  };
  if (m_tasks.size() > 1)
    in_parallel(m_tasks.size(), run_task);
  else if (!m_tasks.empty())
    run_task(0);
  std::vector<int> local(m_position.size());
  for (const int i : m_top)
    if (!is_definite || !compute(a, i, local)) return false;
  return is_definite;
}

void Multifrontal::solve(std::vector<Vec3>& x) const {
  std::vector<double> own, below;
  // Entries of a front are gathered, solved, and put back: down for L, up for its transpose.
  const auto gather = [&](const std::vector<int>& vertices, std::vector<double>& out) {
    out.clear();
    for (const int v : vertices) out.insert(out.end(), {x[v][0], x[v][1], x[v][2]});
  };
  const auto scatter = [&](const std::vector<int>& vertices, const std::vector<double>& in) {
    for (size_t i = 0; i < vertices.size(); ++i)
      x[vertices[i]] = Vec3(in[3 * i], in[3 * i + 1], in[3 * i + 2]);
  };
  for (const Front& front : m_fronts) {
    gather(front.own, own), gather(front.below, below);
    solve_forward(front.values.data(), front.size(), static_cast<int>(own.size()), own.data(),
                  below.data());
    scatter(front.own, own), scatter(front.below, below);
  }
  for (size_t i = m_fronts.size(); i-- > 0;) {
    const Front& front = m_fronts[i];
    gather(front.own, own), gather(front.below, below);
    solve_backward(front.values.data(), front.size(), static_cast<int>(own.size()), own.data(),
                   below.data());
    scatter(front.own, own);
  }
}

}  // namespace trivet::flex
