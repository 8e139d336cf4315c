#include "ops/simulation/fitted_parts.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "core/convex/hull_overlap.h"

namespace trivet {
namespace {

class PartFitter {
 public:
  PartFitter(std::vector<HullTree>& trees, const std::vector<FittedBody>& bodies,
             const std::function<double(size_t, size_t)>& limit)
      : m_trees(trees), m_bodies(bodies), m_limit(limit), m_placed(bodies.size()) {}

  // Halves get a thickness again, so that what was settled may be open once more.
  void run(bool floor) {
    do {
      m_changed = false;
      for (size_t a = 0; a < m_bodies.size(); ++a) {
        if (floor && !m_bodies[a].fixed) fit_to_floor(a);
        // Two fixed bodies may overlap: no simulator pushes them apart.
        for (size_t b = a + 1; b < m_bodies.size(); ++b)
          if (!m_bodies[a].fixed || !m_bodies[b].fixed) fit(a, b);
      }
    } while (m_changed);
  }

 private:
  struct Placed {
    std::unique_ptr<PlacedPart> part;
    double backing = 0, flat = 0;
  };
  struct Pair {
    Index a, b;
  };

  HullTree& tree(size_t body) { return m_trees[m_bodies[body].tree]; }

  const PlacedPart& placed(size_t body, Index node) {
    std::vector<Placed>& all = m_placed[body];
    if (all.size() <= static_cast<size_t>(node)) all.resize(node + 1);
    const HullTree::Node& of_tree = tree(body).node(node);
    Placed& out = all[node];
    // A part whose thickness has changed is placed anew.
    if (!out.part || out.backing != of_tree.backing || out.flat != of_tree.flat) {
      out.part = std::make_unique<PlacedPart>(of_tree.part, m_bodies[body].world_from_tree);
      out.backing = of_tree.backing, out.flat = of_tree.flat;
    }
    return *out.part;
  }

  std::vector<Index> leaves(size_t body, const Aabb* near) {
    std::vector<Index> open, out;
    // The last root goes first, so that leaves come in the order of the tree.
    for (Index i = tree(body).num_roots(); i-- > 0;) open.push_back(i);
    while (!open.empty()) {
      const Index i = open.back();
      open.pop_back();
      const HullTree::Node& node = tree(body).node(i);
      if (!node.is_leaf())
        open.insert(open.end(), node.children.rbegin(), node.children.rend());
      else if (!near || overlaps(placed(body, i).box, *near))
        out.push_back(i);
    }
    return out;
  }

  Aabb box(size_t body) {
    Aabb out;
    for (const Index leaf : leaves(body, nullptr)) out.extend(placed(body, leaf).box);
    return out;
  }

  bool refine(size_t body, Index leaf) {
    // Taking away a thickness adds no part; a split does, and their number is bounded.
    if (tree(body).node(leaf).backing == 0 && tree(body).num_leaves() >= kMaxFittedParts)
      return false;
    if (!tree(body).refine(leaf)) return false;
    return m_changed = true;
  }

  bool thin(size_t body, Index leaf) {
    if (!tree(body).thin(leaf)) return false;
    return m_changed = true;
  }

  /// Metres by which thin() can bring the part closer; 0: the part is not flat.
  double flat_thickness(size_t body, Index leaf) {
    const HullTree::Node& node = tree(body).node(leaf);
    return node.backing > 0 ? 0 : node.flat * m_bodies[body].scale;
  }

  void fit_to_floor(size_t body) {
    std::vector<Index> open = leaves(body, nullptr);
    while (!open.empty()) {
      const Index i = open.back();
      open.pop_back();
      const HullTree::Node& node = tree(body).node(i);
      if (!node.is_leaf())
        open.insert(open.end(), node.children.begin(), node.children.end());
      else if (-placed(body, i).box.lower.z() > m_limit(body, body) && closer_to_floor(body, i))
        open.push_back(i);
    }
  }

  bool closer_to_floor(size_t body, Index i) {
    // A flat part that is below by its thickness alone needs no cut.
    if (-placed(body, i).box.lower.z() <= flat_thickness(body, i) && thin(body, i)) return true;
    return refine(body, i) || thin(body, i);
  }

  void fit(size_t a, size_t b) {
    const Aabb box_a = box(a), box_b = box(b);
    if (!overlaps(box_a, box_b)) return;
    std::vector<Pair> open;
    const std::vector<Index> of_b = leaves(b, &box_a);
    for (const Index i : leaves(a, &box_b))
      for (const Index j : of_b) open.push_back({i, j});
    while (!open.empty()) {
      const Pair pair = open.back();
      open.pop_back();
      const HullTree::Node &of_a = tree(a).node(pair.a), &of_b_node = tree(b).node(pair.b);
      // Pairs are pushed down to leaves, as either may have been split since.
      if (!of_a.is_leaf()) {
        for (const Index child : of_a.children) open.push_back({child, pair.b});
      } else if (!of_b_node.is_leaf()) {
        for (const Index child : of_b_node.children) open.push_back({pair.a, child});
      } else if (const double overlap = depth(a, b, pair);
                 overlap > m_limit(a, b) && closer(a, b, pair, overlap)) {
        open.push_back(pair);
      }
    }
  }

  double depth(size_t a, size_t b, const Pair& pair) {
    const PlacedPart &of_a = placed(a, pair.a), &of_b = placed(b, pair.b);
    return overlaps(of_a.box, of_b.box) ? penetration_depth(of_a, of_b) : 0;
  }

  // Flat parts that overlap by their thickness alone get thinner: no cut would help. Others are
  // thinned last, where nothing can be cut.
  bool closer(size_t a, size_t b, const Pair& pair, double overlap) {
    const double flat_a = flat_thickness(a, pair.a), flat_b = flat_thickness(b, pair.b);
    const auto thin_one = [&] {
      if (flat_a >= flat_b) return thin(a, pair.a) || thin(b, pair.b);
      return thin(b, pair.b) || thin(a, pair.a);
    };
    if (overlap <= std::max(flat_a, flat_b) && thin_one()) return true;
    return refine_one(a, b, pair) || thin_one();
  }

  // Thickness goes first, then the larger part gives way; last a solid, as its parts
  // are hollow.
  bool refine_one(size_t a, size_t b, const Pair& pair) {
    const HullTree::Node &of_a = tree(a).node(pair.a), &of_b = tree(b).node(pair.b);
    if (of_a.solid != of_b.solid) {
      if (of_b.solid) return refine(a, pair.a) || refine(b, pair.b);
      return refine(b, pair.b) || refine(a, pair.a);
    }
    const double metres_a = m_bodies[a].scale, metres_b = m_bodies[b].scale;
    // Thickness counts in metres, as models have units of their own.
    const double backing_a = of_a.backing * metres_a, backing_b = of_b.backing * metres_b;
    const bool a_first = backing_a != backing_b
                             ? backing_a > backing_b
                             : of_a.box.diagonal() * metres_a >= of_b.box.diagonal() * metres_b;
    if (a_first) return refine(a, pair.a) || refine(b, pair.b);
    return refine(b, pair.b) || refine(a, pair.a);
  }

  std::vector<HullTree>& m_trees;
  const std::vector<FittedBody>& m_bodies;
  const std::function<double(size_t, size_t)>& m_limit;
  std::vector<std::vector<Placed>> m_placed;  // of each body, by node
  bool m_changed = false;
};

}  // namespace

bool follow_surface(HullTree& tree, const SurfaceProbe& surface, double limit) {
  bool reached = true;
  std::vector<Index> open;
  for (Index i = tree.num_roots(); i-- > 0;) open.push_back(i);
  while (!open.empty()) {
    const Index i = open.back();
    open.pop_back();
    const HullTree::Node& node = tree.node(i);
    if (!node.is_leaf()) {
      open.insert(open.end(), node.children.rbegin(), node.children.rend());
      continue;
    }
    if (surface.farthest(node.part, {limit, {}}).distance <= limit) continue;
    // A refined part is looked at again, or its halves are.
    if ((node.backing > 0 || tree.num_leaves() < kMaxFittedParts) && tree.refine(i))
      open.push_back(i);
    else
      reached = false;
  }
  return reached;
}

void fit_parts(std::vector<HullTree>& trees, const std::vector<FittedBody>& bodies, bool floor,
               const std::function<double(size_t, size_t)>& limit) {
  PartFitter(trees, bodies, limit).run(floor);
}

}  // namespace trivet
