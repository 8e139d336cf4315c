// Embree, or the median builder, only groups the faces, from boxes in float32 that are centred and
// scaled to 1, so that huge, tiny or distant coordinates do not spoil its arithmetic. The boxes of
// the tree are then computed from the mesh's doubles.
#include "core/index/bvh.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <new>
#include <numeric>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/base/outward.h"
#include "core/base/task_order.h"
#include "core/index/embree.h"
#include "core/index/slabs.h"

namespace trivet {
namespace {

/// Node in the builders' format.
struct BuildNode {
  std::array<BuildNode*, 2> children{};
  std::array<std::array<float, 3>, 2> child_centres{};  // twice the centres
  std::array<Index, kMaxLeafFaces> faces{};
  Index num_faces = 0;  // 0: inner node
};

// ---------------------------------------------------------------------------------------------
// Embree: each callback has the TaskOrder of the build
// ---------------------------------------------------------------------------------------------

BuildNode* allocate_node(RTCThreadLocalAllocator allocator) {
  constexpr size_t kAlignment = 16;
  static_assert(alignof(BuildNode) <= kAlignment);
  void* memory = rtcThreadLocalAlloc(allocator, sizeof(BuildNode), kAlignment);
  if (!memory) throw std::bad_alloc();
  return new (memory) BuildNode;
}

void* create_inner(RTCThreadLocalAllocator allocator, unsigned, void* order) {
  const OrderedStep step(*static_cast<TaskOrder*>(order));
  return allocate_node(allocator);
}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives,
                  size_t num_primitives, void* order) {
  const OrderedStep step(*static_cast<TaskOrder*>(order));
  BuildNode* leaf = allocate_node(allocator);
  for (size_t i = 0; i < num_primitives; ++i)
    leaf->faces[i] = static_cast<Index>(primitives[i].primID);
  leaf->num_faces = static_cast<Index>(num_primitives);
  return leaf;
}

void set_children(void* node, void** children, unsigned num_children, void* order) {
  const OrderedStep step(*static_cast<TaskOrder*>(order));
  for (unsigned i = 0; i < num_children; ++i)
    static_cast<BuildNode*>(node)->children[i] = static_cast<BuildNode*>(children[i]);
}

void set_child_boxes(void* node, const RTCBounds** boxes, unsigned num_children, void* order) {
  const OrderedStep step(*static_cast<TaskOrder*>(order));
  for (unsigned i = 0; i < num_children; ++i)
    static_cast<BuildNode*>(node)->child_centres[i] = {boxes[i]->lower_x + boxes[i]->upper_x,
                                                       boxes[i]->lower_y + boxes[i]->upper_y,
                                                       boxes[i]->lower_z + boxes[i]->upper_z};
}

using BvhMemory = EmbreePointer<RTCBVH>;

/// The root, in `memory`; null if the tree would be too deep. Reorders the primitives.
const BuildNode* build_by_embree(std::vector<RTCBuildPrimitive>& primitives, BvhMemory& memory) {
  const RTCDevice device = embree_device();
  memory.reset(rtcNewBVH(device));
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = 2;
  arguments.maxDepth = kMaxBvhDepth;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = kMaxLeafFaces;
  arguments.bvh = memory.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_inner;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_child_boxes;
  arguments.createLeaf = create_leaf;
  TaskOrder order;
  arguments.userPtr = &order;
  order.give();
  const auto* root = memory ? static_cast<const BuildNode*>(rtcBuildBVH(&arguments)) : nullptr;
  order.take();
  const RTCError error = rtcGetDeviceError(device);
  if (root || (memory && error == RTC_ERROR_UNKNOWN)) return root;  // unknown: "depth limit"
  throw Error(Error::Kind::Environment, "Embree cannot build a tree of " +
                                            std::to_string(primitives.size()) + " faces (error " +
                                            std::to_string(error) +
                                            "); it needs about 200 bytes of memory per face");
}

// ---------------------------------------------------------------------------------------------
// Median splits, for trees too deep for the surface-area heuristic
// ---------------------------------------------------------------------------------------------

std::array<float, 3> twice_centre(const RTCBuildPrimitive& p) {
  return {p.lower_x + p.upper_x, p.lower_y + p.upper_y, p.lower_z + p.upper_z};
}

/// The axis along which the centres of these primitives spread most.
int widest_axis(const std::vector<RTCBuildPrimitive>& primitives, std::span<const Index> chosen) {
  std::array<float, 3> lower = twice_centre(primitives[chosen[0]]), upper = lower;
  for (const Index i : chosen) {
    const std::array<float, 3> centre = twice_centre(primitives[i]);
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], centre[axis]);
      upper[axis] = std::max(upper[axis], centre[axis]);
    }
  }
  int widest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (upper[axis] - lower[axis] > upper[widest] - lower[widest]) widest = axis;
  return widest;
}

BuildNode* build_by_median(const std::vector<RTCBuildPrimitive>& primitives,
                           std::span<Index> chosen, std::deque<BuildNode>& memory) {
  BuildNode* node = &memory.emplace_back();
  if (chosen.size() <= kMaxLeafFaces) {
    for (const Index i : chosen)
      node->faces[node->num_faces++] = static_cast<Index>(primitives[i].primID);
    return node;
  }
  const int axis = widest_axis(primitives, chosen);
  const size_t half = chosen.size() / 2;
  const auto key = [&](Index i) {
    return std::pair(twice_centre(primitives[i])[axis], primitives[i].primID);
  };
  std::nth_element(chosen.begin(), chosen.begin() + half, chosen.end(),
                   [&](Index i, Index j) { return key(i) < key(j); });
  node->children = {build_by_median(primitives, chosen.first(half), memory),
                    build_by_median(primitives, chosen.subspan(half), memory)};
  return node;
}

// ---------------------------------------------------------------------------------------------
// The tree
// ---------------------------------------------------------------------------------------------

std::vector<RTCBuildPrimitive> make_primitives(const Mesh& mesh) {
  const Aabb box = mesh.box();
  const Vec3 centre = box.centre();
  const double scale =
      1 / std::max(box.half_extent().maxCoeff(), std::numeric_limits<double>::min());
  std::vector<RTCBuildPrimitive> out(mesh.triangles.size());
  for (Index f = 0; f < static_cast<Index>(out.size()); ++f) {
    const Triangle t = mesh.triangle(f);
    const Eigen::Vector3f lower =
        ((t[0].cwiseMin(t[1]).cwiseMin(t[2]) - centre) * scale).cast<float>();
    const Eigen::Vector3f upper =
        ((t[0].cwiseMax(t[1]).cwiseMax(t[2]) - centre) * scale).cast<float>();
    out[f] = {lower.x(), lower.y(), lower.z(), 0,
              upper.x(), upper.y(), upper.z(), static_cast<unsigned>(f)};
  }
  return out;
}

/// The child nearer to the start of the axis that separates the two most comes first.
bool second_comes_first(const BuildNode& node) {
  int axis = 0;
  std::array<float, 3> ahead;
  for (int k = 0; k < 3; ++k) {
    ahead[k] = node.child_centres[1][k] - node.child_centres[0][k];
    if (std::abs(ahead[k]) > std::abs(ahead[axis])) axis = k;
  }
  return ahead[axis] < 0;
}

/// Appends the subtree depth-first, without boxes.
void append(const BuildNode& node, Bvh& out) {
  const size_t id = out.nodes.size();
  out.nodes.emplace_back();
  if (node.num_faces > 0) {
    out.nodes[id].second_child = static_cast<Index>(out.faces.size());
    out.nodes[id].num_faces = node.num_faces;
    out.faces.insert(out.faces.end(), node.faces.begin(), node.faces.begin() + node.num_faces);
    std::sort(out.faces.end() - node.num_faces, out.faces.end());
    return;
  }
  const bool swapped = second_comes_first(node);
  append(*node.children[swapped], out);
  out.nodes[id].second_child = static_cast<Index>(out.nodes.size());
  append(*node.children[!swapped], out);
}

/// Boxes of all nodes, children before parents.
void set_boxes(const Mesh& mesh, Bvh& bvh) {
  for (size_t id = bvh.nodes.size(); id-- > 0;) {
    BvhNode& node = bvh.nodes[id];
    if (node.is_leaf()) {
      Aabb box;
      for (Index i = 0; i < node.num_faces; ++i)
        for (const Vec3& p : mesh.triangle(bvh.faces[node.second_child + i])) box.extend(p);
      for (int axis = 0; axis < 3; ++axis) {
        node.lower[axis] = float_below(box.lower[axis]);
        node.upper[axis] = float_above(box.upper[axis]);
      }
    } else {
      const BvhNode& first = bvh.nodes[id + 1];
      const BvhNode& second = bvh.nodes[node.second_child];
      for (int axis = 0; axis < 3; ++axis) {
        node.lower[axis] = std::min(first.lower[axis], second.lower[axis]);
        node.upper[axis] = std::max(first.upper[axis], second.upper[axis]);
      }
    }
  }
}

}  // namespace

Bvh build_bvh(const Mesh& mesh) {
  Bvh bvh;
  if (mesh.triangles.empty()) return bvh;
  std::vector<RTCBuildPrimitive> primitives = make_primitives(mesh);
  BvhMemory embree_memory;
  std::deque<BuildNode> median_memory;
  const BuildNode* root = build_by_embree(primitives, embree_memory);
  if (!root) {
    std::vector<Index> all(primitives.size());
    std::iota(all.begin(), all.end(), 0);
    root = build_by_median(primitives, all, median_memory);
  }
  bvh.faces.reserve(mesh.triangles.size());
  append(*root, bvh);
  bvh.nodes.shrink_to_fit();
  set_boxes(mesh, bvh);
  bvh.slabs = make_slabs(mesh, bvh);
  return bvh;
}

}  // namespace trivet
