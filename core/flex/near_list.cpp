#include "core/flex/near_list.h"

#include <algorithm>

namespace trivet::flex {
namespace {

// Boxes become larger by a part of their size, as the next step is alike.
constexpr double kAhead = 0.5;
constexpr double kMostAhead = 4;  // slacks

bool holds_box(const Aabb& outer, const Aabb& inner) {
  return (outer.lower.array() <= inner.lower.array()).all() &&
         (outer.upper.array() >= inner.upper.array()).all();
}

// From a point to the farthest corner of the box around it.
double reach(const Aabb& box, const Vec3& from) {
  return (box.upper - from).cwiseMax(from - box.lower).norm();
}

}  // namespace

NearList::NearList(Surroundings& surroundings, double outside, double own, double slack)
    : m_surroundings(surroundings), m_outside(outside), m_own(own), m_slack(slack) {}

bool NearList::holds(std::span<const Aabb> boxes) const {
  if (m_boxes.size() != boxes.size()) return false;
  for (size_t v = 0; v < boxes.size(); ++v)
    if (!holds_box(m_boxes[v], boxes[v])) return false;
  return true;
}

bool NearList::gather(const Points& x, std::span<const Aabb> boxes) {
  m_boxes.assign(boxes.begin(), boxes.end());
  std::vector<double> reaches(x.size());
  for (size_t v = 0; v < x.size(); ++v) {
    const double size = (m_boxes[v].upper - m_boxes[v].lower).maxCoeff();
    grow(m_boxes[v], std::clamp(kAhead * size, m_slack, kMostAhead * m_slack));
    reaches[v] = reach(m_boxes[v], x[v]);
  }
  // Boxes of elements touch long before the elements do: those that cannot meet are left out.
  const auto may_meet = [&](const NearPair& pair) {
    const PairPoints points = m_surroundings.points(pair, x);
    double sides[2] = {0, 0};
    for (int k = 0; k < points.count; ++k) {
      double& side = sides[k >= points.first];
      side = std::max(side, reaches[points.vertices[k]]);
    }
    return points.distance <= (pair.is_own() ? m_own : m_outside) + sides[0] + sides[1];
  };
  if (m_surroundings.find(m_boxes, m_outside, m_own, m_pairs, may_meet)) return true;
  m_boxes.clear();
  return false;
}

const std::vector<NearPair>* NearList::within(const Points& x, std::span<const Aabb> boxes) {
  if (!holds(boxes) && !gather(x, boxes)) return nullptr;
  return &m_pairs;
}

}  // namespace trivet::flex
