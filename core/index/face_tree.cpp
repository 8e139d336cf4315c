// Wald, On fast construction of SAH-based bounding volume hierarchies, 2007.
#include "core/index/face_tree.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "core/base/in_parallel.h"

namespace trivet {
namespace {

constexpr int kMaxBins = 16, kFewBins = 8;
constexpr size_t kFewOfBins = 64;  // are split by kFewBins
constexpr size_t kFewOfTree = 8;   // are split by all their places along one axis
constexpr float kLeastExtent = 1e-30F;

using Array4 = Eigen::Array4f;

struct Bounds {
  Array4 lower = Array4::Constant(std::numeric_limits<float>::infinity());
  Array4 upper = -lower;

  void extend(const Array4& a, const Array4& b) { lower = lower.min(a), upper = upper.max(b); }
  void extend(const Bounds& b) { extend(b.lower, b.upper); }
  float half_area() const {
    const Array4 d = upper - lower;
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
  int widest_axis() const {
    int axis = 0;
    (upper - lower).head<3>().maxCoeff(&axis);
    return axis;
  }
};

/// Intervals of equal width along each axis, of the centres of some faces.
struct Bins {
  int count;
  Array4 first, per_length;  // of twice the centres

  Bins(const Bounds& centres, int num_bins) : count(num_bins), first(centres.lower) {
    for (int k = 0; k < 4; ++k) {
      const float extent = centres.upper[k] - centres.lower[k];
      per_length[k] = extent > kLeastExtent ? static_cast<float>(count) / extent : 0;
    }
  }
  Eigen::Array4i of(const Array4& centre) const {
    return ((centre - first) * per_length).cast<int>().min(count - 1);
  }
  int of(const Array4& centre, int axis) const {
    return std::min(static_cast<int>((centre[axis] - first[axis]) * per_length[axis]), count - 1);
  }
};

struct Bin {
  Bounds bounds;
  int num_faces = 0;
};

/// Faces in bins before `bin` along an axis go to the first child.
struct Split {
  int axis = -1, bin = 0;
  float cost = std::numeric_limits<float>::infinity();
};

class FaceTree {
 public:
  explicit FaceTree(const std::vector<FaceBox>& boxes) : m_boxes(boxes) {}

  Bvh make(bool by_median) const {
    std::vector<Index> faces(m_boxes.size());
    std::iota(faces.begin(), faces.end(), 0);
    Bvh out;
    out.nodes.reserve(2 * faces.size());
    out.faces.reserve(faces.size());
    append(faces, 1, by_median, out);
    out.nodes.shrink_to_fit();
    return out;
  }

 private:
  using Faces = std::span<Index>;
  using Few = std::array<Index, kFewOfTree>;

  Array4 centre(Index face) const { return m_boxes[face].lower + m_boxes[face].upper; }

  Bounds bounds_of_centres(Faces faces) const {
    Bounds out;
    for (const Index f : faces) out.extend(centre(f), centre(f));
    return out;
  }

  // Too deep: leaves out.nodes empty.
  bool append(Faces faces, int depth, bool by_median, Bvh& out) const {
    // Traversals keep a stack of this depth; make_face_tree() halves instead.
    if (depth > kMaxBvhDepth) return out.nodes.clear(), false;
    const size_t id = out.nodes.size();
    out.nodes.emplace_back();
    const size_t half = by_median ? halve(faces) : divide(faces);
    if (half == faces.size()) {
      out.nodes[id].second_child = static_cast<Index>(out.faces.size());
      out.nodes[id].num_faces = static_cast<Index>(faces.size());
      // Faces of a leaf come in the order of the mesh, whatever moved them here.
      std::sort(faces.begin(), faces.end());
      out.faces.insert(out.faces.end(), faces.begin(), faces.end());
      return true;
    }
    const Faces children[] = {faces.first(half), faces.subspan(half)};
    if (faces.size() > kManyFaces) return append_in_parallel(children, depth, by_median, id, out);
    if (!append(children[0], depth + 1, by_median, out)) return false;
    out.nodes[id].second_child = static_cast<Index>(out.nodes.size());
    return append(children[1], depth + 1, by_median, out);
  }

  bool append_in_parallel(std::span<const Faces, 2> children, int depth, bool by_median, size_t id,
                          Bvh& out) const {
    Bvh parts[2];
    // Each half grows a tree of its own; their numbers are shifted when they are joined.
    in_parallel(2, [&](size_t k) { append(children[k], depth + 1, by_median, parts[k]); });
    for (const Bvh& part : parts) {
      if (part.nodes.empty()) return out.nodes.clear(), false;
      const auto nodes_before = static_cast<Index>(out.nodes.size());
      const auto faces_before = static_cast<Index>(out.faces.size());
      for (BvhNode node : part.nodes) {
        node.second_child += node.is_leaf() ? faces_before : nodes_before;
        out.nodes.push_back(node);
      }
      out.faces.insert(out.faces.end(), part.faces.begin(), part.faces.end());
      if (&part == parts) out.nodes[id].second_child = static_cast<Index>(out.nodes.size());
    }
    return true;
  }

  // --- where to split; all faces: a leaf ---------------------------------------------------------

  // The surface area heuristic: a split costs the area of each side times its faces.
  size_t divide(Faces faces) const {
    if (faces.size() == 1) return 1;
    if (faces.size() <= kFewOfTree) return divide_few(faces);
    const bool is_small = faces.size() <= kFewOfBins;
    const Bins bins(bounds_of_centres(faces), is_small ? kFewBins : kMaxBins);
    const Split split =
        is_small ? best_split<kFewBins>(faces, bins) : best_split<kMaxBins>(faces, bins);
    if (split.axis < 0) return halve(faces);
    // Faces in bins before the split go to the first child.
    const auto second = std::partition(faces.begin(), faces.end(), [&](Index f) {
      return bins.of(centre(f), split.axis) < split.bin;
    });
    return static_cast<size_t>(second - faces.begin());
  }

  // Few enough share a leaf unless their boxes are small against that of all.
  size_t divide_few(Faces faces) const {
    const bool may_be_leaf = faces.size() <= kMaxLeafFaces;
    // Few faces are sorted along each axis in turn: all their splits are compared, where bins would
    // round them off.
    Split best;
    Few chosen;
    for (int axis = 0; axis < 3; ++axis) {
      Few order = sorted_along(axis, faces);
      const Split found = best_split_of_few({order.data(), faces.size()}, axis);
      if (found.cost < best.cost) best = found, chosen = order;
    }
    if (may_be_leaf && !(best.cost < leaf_cost(faces))) return faces.size();
    // Costs that overflow name no split: halves are as good.
    if (best.axis < 0) return halve(faces);
    std::copy_n(chosen.begin(), faces.size(), faces.begin());
    return static_cast<size_t>(best.bin);
  }

  // Cost of testing the boxes of a leaf; opening a node costs as much as a face.
  float leaf_cost(Faces faces) const {
    Bounds all;
    for (const Index f : faces) all.extend(m_boxes[f].lower, m_boxes[f].upper);
    return static_cast<float>(faces.size() - 1) * all.half_area();
  }

  // Best split of faces in this order; the bin is how many the first child gets.
  Split best_split_of_few(Faces faces, int axis) const {
    const size_t count = faces.size();
    std::array<float, kFewOfTree> cost_after;  // of this face and those after it
    Bounds all;
    // One sweep from the end prices the second children, one from the start the first.
    for (size_t k = count; --k > 0;) {
      all.extend(m_boxes[faces[k]].lower, m_boxes[faces[k]].upper);
      cost_after[k] = static_cast<float>(count - k) * all.half_area();
    }
    Split best;
    all = {};
    for (size_t k = 1; k < count; ++k) {
      all.extend(m_boxes[faces[k - 1]].lower, m_boxes[faces[k - 1]].upper);
      const float cost = static_cast<float>(k) * all.half_area() + cost_after[k];
      if (cost < best.cost) best = {axis, static_cast<int>(k), cost};
    }
    return best;
  }

  // By insertion: they are few.
  Few sorted_along(int axis, Faces faces) const {
    std::array<float, kFewOfTree> keys;
    Few out;
    for (size_t n = 0; n < faces.size(); ++n) {
      const float key = centre(faces[n])[axis];
      size_t k = n;
      for (; k > 0 && std::pair(key, faces[n]) < std::pair(keys[k - 1], out[k - 1]); --k)
        keys[k] = keys[k - 1], out[k] = out[k - 1];
      keys[k] = key, out[k] = faces[n];
    }
    return out;
  }

  template <int kBins>
  Split best_split(Faces faces, const Bins& bins) const {
    std::array<std::array<Bin, kBins>, 3> filled;
    // One pass fills the bins of all three axes.
    for (const Index f : faces) {
      const FaceBox& box = m_boxes[f];
      const Eigen::Array4i at = bins.of(box.lower + box.upper);
      for (int axis = 0; axis < 3; ++axis) {
        Bin& bin = filled[axis][at[axis]];
        bin.bounds.extend(box.lower, box.upper);
        ++bin.num_faces;
      }
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis)
      if (bins.per_length[axis] > 0) improve(filled[axis], axis, best);
    return best;
  }

  template <size_t kBins>
  static void improve(const std::array<Bin, kBins>& bins, int axis, Split& best) {
    std::array<float, kBins> cost_after;  // of this bin and those after it
    Bin all;
    // The same two sweeps over bins.
    for (int k = kBins; --k > 0;) {
      all.bounds.extend(bins[k].bounds);
      all.num_faces += bins[k].num_faces;
      cost_after[k] = cost(all);
    }
    all = {};
    for (int k = 1; k < static_cast<int>(kBins); ++k) {
      all.bounds.extend(bins[k - 1].bounds);
      all.num_faces += bins[k - 1].num_faces;
      if (const float sum = cost(all) + cost_after[k]; sum < best.cost) best = {axis, k, sum};
    }
  }

  // Infinity: no faces.
  static float cost(const Bin& bin) {
    return bin.num_faces == 0 ? std::numeric_limits<float>::infinity()
                              : static_cast<float>(bin.num_faces) * bin.bounds.half_area();
  }

  size_t halve(Faces faces) const {
    if (faces.size() <= kMaxLeafFaces) return faces.size();
    // The widest axis is cut in the middle.
    const int axis = bounds_of_centres(faces).widest_axis();
    const size_t half = faces.size() / 2;
    // Equal centres are told apart by their numbers, so that every library orders them alike.
    const auto key = [&](Index f) { return std::pair(centre(f)[axis], f); };
    std::nth_element(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(half), faces.end(),
                     [&](Index f, Index g) { return key(f) < key(g); });
    return half;
  }

  const std::vector<FaceBox>& m_boxes;
};

}  // namespace

std::vector<FaceBox> face_boxes(const Mesh& mesh) {
  const Aabb box = mesh.box();
  // Boxes are scaled about the mesh's centre, so that float32 has digits to spare.
  const Vec3 centre = box.centre();
  const double scale =
      1 / std::max(box.half_extent().maxCoeff(), std::numeric_limits<double>::min());
  std::vector<FaceBox> out(mesh.triangles.size());
  for (Index f = 0; f < static_cast<Index>(out.size()); ++f) {
    const Triangle t = mesh.triangle(f);
    const auto put = [&](const Vec3& p, Array4& to) {
      to << ((p - centre) * scale).cast<float>().array(), 0;
    };
    put(t[0].cwiseMin(t[1]).cwiseMin(t[2]), out[f].lower);
    put(t[0].cwiseMax(t[1]).cwiseMax(t[2]), out[f].upper);
  }
  return out;
}

Bvh make_face_tree(const std::vector<FaceBox>& boxes) {
  const FaceTree tree(boxes);
  Bvh out = tree.make(false);
  return out.nodes.empty() ? tree.make(true) : out;
}

}  // namespace trivet
