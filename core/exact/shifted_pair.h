// Two placed shapes of which one is shifted again and again: do they cross?
#pragma once

#include <optional>
#include <vector>

#include "core/exact/interpenetration.h"
#include "core/exact/separating_axes.h"

namespace trivet {

/// Keeps what shifts leave as it is: boxes along all axes, and the faces that crossed last, which
/// often cross again.
class ShiftedPair {
 public:
  /// Keeps references. Positions are those of world_from_object.
  ShiftedPair(const PlacedShape& a, const PlacedShape& b);

  /// As count_crossings() > 0, of `a` shifted: exact.
  bool cross(const Vec3& by);

 private:
  /// Boxes of nodes that were met last.
  class Boxes {
   public:
    explicit Boxes(size_t num_nodes);
    template <class Make>
    const SeparatingAxes::AlongAxes& get(Index node, const Make& make);

   private:
    struct Slot {
      Index node = -1;
      SeparatingAxes::AlongAxes box;
    };
    std::vector<Slot> m_slots;
  };

  const PlacedShape &m_a, &m_b;
  Boxes m_boxes_a, m_boxes_b;
  std::optional<CrossingPair> m_last;
};

}  // namespace trivet
