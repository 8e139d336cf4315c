// A container around an object, by columns: a larger object whose rim is above its underside.
#include <algorithm>

#include "ops/mend/intent_order.h"

namespace trivet {
namespace {

constexpr double kInsideShare = 0.45;  // of columns within the container

// The foot is the lowest quarter of the object; most of it has to be within the other's box, over
// its faces.
bool has_foot_within(const Looked& l, size_t k, const Aabb& box, double low, double high) {
  size_t foot = 0, within = 0;
  for (const Column& c : l.columns.columns) {
    if (c.low > low + 0.25 * (high - low)) continue;
    ++foot;
    const bool around = (c.at.array() > box.lower.head<2>().array()).all() &&
                        (c.at.array() < box.upper.head<2>().array()).all();
    within += around && c.others[k].highest_under > kNoHeight;
  }
  return static_cast<double>(within) >=
         kInsideShare * static_cast<double>(std::max<size_t>(foot, 3));
}

// The other has walls within a size of the object: its faces above the rim are not only over the
// object's own columns' tops. Its box tells for lack of anything better.
bool surrounds(const Aabb& box, const Aabb& mine, double rim) {
  return box.upper.z() > rim && box.lower.x() < mine.centre().x() &&
         box.upper.x() > mine.centre().x() && box.lower.y() < mine.centre().y() &&
         box.upper.y() > mine.centre().y();
}

}  // namespace

std::optional<ObjectId> container_of(const Scene& scene, const Looked& l) {
  const double low = lowest(l), size = size_of(scene.at(l.intent.id));
  const Aabb mine = scene.world_box(l.intent.id);
  double high = kNoHeight;
  for (const Column& c : l.columns.columns) high = std::max(high, c.high);
  // The rim has to be above the object's underside by a part of its height.
  const double rim = std::max(0.004, 0.15 * std::min(0.1, high - low));
  std::optional<ObjectId> out;
  double best = kInfinity;
  for (size_t k = 0; k < l.columns.others.size(); ++k) {
    const ObjectId other = l.columns.others[k];
    const double its_size = size_of(scene.at(other));
    const Aabb box = scene.world_box(other);
    if (box.upper.z() < low + rim || its_size < size) continue;
    if (!has_foot_within(l, k, box, low, high) || !surrounds(box, mine, low + rim)) continue;
    // The smallest container is the one that is meant.
    if (its_size >= best) continue;
    best = its_size;
    out = other;
  }
  return out;
}

}  // namespace trivet
