// Embree sees the boxes clamped to the extent of those of b and scaled to 1, axis by axis: this
// changes no overlap, and huge, tiny or distant coordinates cost float32 no digits.
#include "core/index/box_pairs.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <vector>

#include "core/base/arena.h"
#include "core/base/outward.h"
#include "core/index/embree.h"

namespace trivet {
namespace {

struct FloatBox {
  std::array<float, 3> lower, upper;
};

/// The boxes that Embree sees, and the caller's indices of them.
struct BoxSet {
  std::vector<FloatBox> boxes;
  std::vector<Index> ids;
};

/// To coordinates in which the boxes of b have an extent of 1.
class Scaling {
 public:
  explicit Scaling(std::span<const Aabb> b) {
    for (const Aabb& box : b) m_extent.extend(box);
    for (int k = 0; k < 3; ++k) {
      const double length = m_extent.upper[k] - m_extent.lower[k];
      m_factor[k] = length > 0 && 1 / length < kInfinity ? 1 / length : 0;
    }
  }

  BoxSet apply(std::span<const Aabb> boxes) const {
    BoxSet out;
    for (Index i = 0; i < static_cast<Index>(boxes.size()); ++i) {
      // Boxes beside all of b overlap none of them.
      if (!overlaps(boxes[i], m_extent)) continue;
      out.boxes.push_back(scaled(boxes[i]));
      out.ids.push_back(i);
    }
    return out;
  }

 private:
  // Clamping and scaling are monotonous, rounding included: boxes that overlap still do.
  FloatBox scaled(const Aabb& box) const {
    FloatBox out;
    for (int k = 0; k < 3; ++k) {
      const double lower = std::max(box.lower[k], m_extent.lower[k]) - m_extent.lower[k];
      const double upper = std::min(box.upper[k], m_extent.upper[k]) - m_extent.lower[k];
      out.lower[k] = float_below(lower * m_factor[k]);
      out.upper[k] = float_above(upper * m_factor[k]);
    }
    return out;
  }

  Aabb m_extent;
  Vec3 m_factor = Vec3::Zero();
};

bool overlap(const FloatBox& a, const FloatBox& b) {
  for (int k = 0; k < 3; ++k)
    if (a.lower[k] > b.upper[k] || b.lower[k] > a.upper[k]) return false;
  return true;
}

/// About how many pairs overlap, from pairs taken at even steps, a few per box.
double estimated_pairs(const std::vector<FloatBox>& a, const std::vector<FloatBox>& b) {
  constexpr size_t kTriesPerBox = 16;
  const size_t num_tries = kTriesPerBox * (a.size() + b.size());
  const auto num_pairs = static_cast<double>(a.size()) * static_cast<double>(b.size());
  if (num_pairs <= static_cast<double>(num_tries)) return num_pairs;
  // Pairs are taken at pseudo-random steps, the same on every machine.
  size_t num_hits = 0, i = 0, j = 0;
  for (size_t n = 0; n < num_tries; ++n) {
    num_hits += overlap(a[i], b[j]);
    if (++i == a.size()) i = 0;
    j = (j * 1664525 + 1013904223 + i) % b.size();
  }
  return num_pairs * static_cast<double>(num_hits) / static_cast<double>(num_tries);
}

void give_box(const RTCBoundsFunctionArguments* arguments) {
  const auto& box = static_cast<const FloatBox*>(arguments->geometryUserPtr)[arguments->primID];
  RTCBounds& out = *arguments->bounds_o;
  out.lower_x = box.lower[0], out.lower_y = box.lower[1], out.lower_z = box.lower[2];
  out.upper_x = box.upper[0], out.upper_y = box.upper[1], out.upper_z = box.upper[2];
}

EmbreePointer<RTCScene> make_scene(const std::vector<FloatBox>& boxes) {
  const RTCDevice device = embree_device();
  EmbreePointer<RTCScene> scene(rtcNewScene(device));
  const EmbreePointer<RTCGeometry> geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  if (!scene || !geometry) return {};
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_LOW);
  rtcSetGeometryBuildQuality(geometry.get(), RTC_BUILD_QUALITY_LOW);
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(boxes.size()));
  // Embree only reads them.
  rtcSetGeometryUserData(geometry.get(), const_cast<FloatBox*>(boxes.data()));
  rtcSetGeometryBoundsFunction(geometry.get(), give_box, nullptr);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene.get(), geometry.get());
  rtcCommitScene(scene.get());
  return scene;
}

struct Visit {
  const BoxSet &a, &b;
  const std::function<void(const BoxPair&)>& visit;
  std::mutex mutex;
};

void call(void* user, RTCCollision* collisions, unsigned num_collisions) {
  auto& all = *static_cast<Visit*>(user);
  const std::lock_guard lock(all.mutex);  // Embree may call from several threads
  for (unsigned n = 0; n < num_collisions; ++n) {
    const unsigned i = collisions[n].primID0, j = collisions[n].primID1;
    // Embree does not compare boxes of a scene that is a single leaf.
    if (overlap(all.a.boxes[i], all.b.boxes[j])) all.visit({all.a.ids[i], all.b.ids[j]});
  }
}

}  // namespace

bool visit_overlapping_boxes(std::span<const Aabb> a, std::span<const Aabb> b, std::size_t most,
                             const std::function<void(const BoxPair&)>& visit) {
  const Scaling scaling(b);
  const BoxSet boxes_a = scaling.apply(a), boxes_b = scaling.apply(b);
  if (boxes_a.boxes.empty() || boxes_b.boxes.empty()) return true;
  // Too many pairs would take longer to visit than the caller saves.
  if (estimated_pairs(boxes_a.boxes, boxes_b.boxes) > static_cast<double>(most)) return false;
  Visit all{boxes_a, boxes_b, visit, {}};
  // One thread: sets are small, and a wait for others' tasks would cost more than it gains.
  in_arena(1, [&] {
    const EmbreePointer<RTCScene> scene_a = make_scene(boxes_a.boxes),
                                  scene_b = make_scene(boxes_b.boxes);
    throw_embree_error("tell which boxes overlap");
    if (scene_a && scene_b) rtcCollide(scene_a.get(), scene_b.get(), call, &all);
    throw_embree_error("tell which boxes overlap");
  });
  return true;
}

}  // namespace trivet
