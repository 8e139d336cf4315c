// Private. Places of a thing by their costs with noise: heights are looked at only where a place's
// turn comes.
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
  std::optional<bool> faces(size_t relation) const;
  bool is_near(size_t relation) const;

  const Placer& m_placer;
  const Outline& m_base;
  Outline m_here;
  std::vector<std::optional<double>> m_fixed;  // of relations that are of the rotation alone
  std::vector<double> m_cosines;               // of the widest angles of those that face something
  struct Known {
    Vec2 at = Vec2::Zero();
    double distance = -1;  // less than 0: none yet
  };
  mutable std::vector<Known> m_known;  // of each Near, where it was measured last
};

/// Places that fit, the best first, a pixel or more from each other, each found when it is asked
/// for. The scene is to be as it was at the beginning then.
class PlaceOrder {
 public:
  /// @param nogoods  positions that are left out, by 6 mm; outlive this.
  PlaceOrder(const Placer& placer, Obstacles which, const std::vector<Vec2>& nogoods);
  /// nullopt: there are no more.
  std::optional<PlaceCandidate> next();

 private:
  // A rotation with the height maps of its places, drawn when they are asked for.
  struct Open {
    Open(const Placer& placer, const Combination& c) : combination(c), field(placer.field(c)) {}
    const Combination& combination;
    PlaceField field;
    std::optional<Obstructions> in_the_way;
  };

  void add_turns(bool few);
  void add(size_t combination);
  std::vector<size_t> met(const PlaceField& field, PlaceCosts& costs) const;
  Obstructions obstructions(const Open& open) const;
  bool fits(PlaceCandidate& candidate);
  bool meets_sights(const PlaceCandidate& candidate);
  bool is_close(const PlaceCandidate& candidate) const;
  bool take(const PlaceCandidate& candidate);
  auto later() const {
    return [this](size_t i, size_t j) {
      return m_all[i].key != m_all[j].key ? m_all[i].key > m_all[j].key : i > j;
    };
  }
  void start();
  std::optional<PlaceCandidate> pop();
  std::optional<PlaceCandidate> next_of_these();
  std::vector<PlaceCandidate> with_sight_energy();

  const Placer& m_placer;
  Obstacles m_which;
  const std::vector<Vec2>& m_nogoods;
  std::vector<std::unique_ptr<Open>> m_open;
  std::vector<PlaceCandidate> m_all;
  std::vector<size_t> m_heap;           // of these, the best on top
  std::vector<PlaceCandidate> m_first;  // before them, by soft sights, too; the best at the back
  std::vector<PlaceCandidate> m_given;
  size_t m_num_sights = 0;
  bool m_has_more = false;                            // turns that were not added yet
  std::vector<std::unique_ptr<SightJudge>> m_judges;  // of hard relations of sight
};

}  // namespace trivet
