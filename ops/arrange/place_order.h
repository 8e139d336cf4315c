// Private. Places of a thing by their costs with noise: heights are looked at only where a place's
// turn comes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "ops/arrange/placer.h"

namespace trivet {

/// Costs of a thing's relations by outlines, in one rotation, place by place.
class PlaceCosts {
 public:
  PlaceCosts(const Placer& placer, const Combination& combination);
  void move_to(const Vec2& at);
  /// In the combination's region. But for things that are turned to face something afterwards:
  /// kFacingSlackDeg.
  bool meets_hard() const;
  /// Energy of the soft relations: not negative.
  double energy() const;

 private:
  double cost(size_t relation) const;
  std::optional<bool> faces(size_t relation) const;
  bool is_near(size_t relation) const;
  const Outline& here() const;

  const Placer& m_placer;
  const Outline& m_base;
  mutable Outline m_here;  // without its hull until that is asked for
  Vec2 m_at = Vec2::Zero();
  mutable bool m_has_hull = false;
  std::vector<size_t> m_hard, m_soft;          // relations; hard ones that the region leaves open
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
    Open(const Placer& placer, size_t c)
        : index(c),
          combination(placer.combinations()[c]),
          field(placer.field(combination)),
          costs(placer, combination) {}
    size_t index;  // of the combination
    const Combination& combination;
    PlaceField field;
    PlaceCosts costs;
    std::optional<Obstructions> in_the_way;
  };
  struct Entry {
    double key = 0;  // without the soft costs until these are known
    std::optional<double> energy;
    std::uint32_t field = 0, place = 0;
  };

  void add_turns(bool few);
  void add(size_t combination);
  std::vector<size_t> met(Open& open) const;
  Obstructions obstructions(const Open& open) const;
  bool fits(PlaceCandidate& candidate);
  bool meets_sights(const PlaceCandidate& candidate);
  bool is_close(const PlaceCandidate& candidate) const;
  bool take(const PlaceCandidate& candidate);
  // The smallest key, then the first that was added, on top.
  static bool is_later(const Entry& a, const Entry& b) {
    return std::tie(a.key, a.field, a.place) > std::tie(b.key, b.field, b.place);
  }
  std::optional<PlaceCandidate> pop();
  void add_soft_costs(Entry& entry);
  PlaceCandidate candidate_of(const Entry& entry) const;
  std::optional<PlaceCandidate> next_of_these();
  std::vector<PlaceCandidate> with_sight_energy();

  const Placer& m_placer;
  Obstacles m_which;
  const std::vector<Vec2>& m_nogoods;
  std::vector<std::unique_ptr<Open>> m_open;
  std::vector<Entry> m_heap;            // the best on top
  std::vector<PlaceCandidate> m_first;  // before them, by soft sights, too; the best at the back
  std::vector<PlaceCandidate> m_given;
  size_t m_num_sights = 0;
  bool m_has_more = false;                            // turns that were not added yet
  std::vector<std::unique_ptr<SightJudge>> m_judges;  // of hard relations of sight
};

}  // namespace trivet
