// Private. The best places of a thing: costs and noise of all places first, heights only of those
// whose turn comes.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ops/arrange/placer.h"

namespace trivet {

/// Costs of a thing's relations by outlines, in one rotation, place by place.
class PlaceCosts {
 public:
  PlaceCosts(const Placer& placer, const Combination& combination);
  void move_to(const Vec2& at);
  /// But for things that are turned to face something afterwards: kFacingSlackDeg.
  bool meets_hard() const;
  /// Of the soft relations.
  double energy() const;

 private:
  double cost(size_t relation) const;

  const Placer& m_placer;
  const Outline& m_base;
  Outline m_here;
  std::vector<std::optional<double>> m_fixed;  // of relations that are of the rotation alone
};

class PlaceOrder {
 public:
  PlaceOrder(const Placer& placer, Obstacles which, const std::vector<Vec2>& nogoods)
      : m_placer(placer), m_which(which), m_nogoods(nogoods) {}

  /// Adds the places that all relations leave in one rotation, whatever is in the way.
  void add(size_t combination);
  /// The best that fit, a pixel or more from each other.
  std::vector<PlaceCandidate> best(size_t most);

 private:
  // A rotation with the height maps of its places, drawn when they are asked for.
  struct Open {
    Open(const Placer& placer, const Combination& c) : combination(c), field(placer.field(c)) {}
    const Combination& combination;
    PlaceField field;
    std::optional<Obstructions> in_the_way;
  };

  std::vector<size_t> met(const PlaceField& field, PlaceCosts& costs) const;
  Obstructions obstructions(const Open& open) const;
  bool fits(PlaceCandidate& candidate);
  bool meets_sights(const PlaceCandidate& candidate);
  void start();
  std::optional<PlaceCandidate> next();
  std::optional<PlaceCandidate> next_that_fits();
  std::vector<PlaceCandidate> with_sight_energy();

  const Placer& m_placer;
  Obstacles m_which;
  const std::vector<Vec2>& m_nogoods;
  std::vector<std::unique_ptr<Open>> m_open;
  std::vector<PlaceCandidate> m_all;
  std::vector<size_t> m_heap;                         // of these, the best on top
  std::vector<std::unique_ptr<SightJudge>> m_judges;  // of hard relations of sight
};

}  // namespace trivet
