// Places for one thing: candidates by height maps and relations, in the order of their cost with
// noise, and PUT as the judge of each.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/arrange/relations.h"
#include "ops/arrange/sights.h"
#include "ops/arrange/world.h"

namespace trivet {

/// Turns about z that are tried for things that face something; they are turned to it afterwards.
inline constexpr int kFacingTurns = 32;
inline constexpr double kFacingSlackDeg = 180.0 / kFacingTurns;
/// Tilt of a thing at rest against its trial, at most.
inline constexpr double kMostTiltDeg = 3;

/// A rotation, a way down and where the position may be: what one field of places is computed for.
struct Combination {
  Rotation rotation;
  Outline outline;  // at position zero
  Landing landing;
  ConvexRegion region;
  size_t turn = 0;  // index of it about z
};

struct PlaceCandidate {
  double key = 0;     // cost less noise: the smallest comes first
  double energy = 0;  // of the soft relations
  size_t combination = 0;
  double start_z = 0;  // of the position, where it is certain to have met its support
  Vec2 at = Vec2::Zero();
  double pixel = 0;
  size_t field = 0, place = 0;  // of the search
};

using Obstructions = std::vector<std::unique_ptr<PlaceField::Obstruction>>;

/// Objects that count as obstacles.
enum class Obstacles {
  All,
  Immovable,  // all but the things to arrange
};

enum class Noise {
  On,   // places are sampled by their cost
  Off,  // the cheapest come first
};

class Placer {
 public:
  /// @param thing  index. @param seed  of this search.
  Placer(World& world, size_t thing, std::uint64_t seed, Noise noise = Noise::On);

  /// Rotations and windows that the hard relations leave; empty: they cannot be met, by outlines
  /// alone.
  const std::vector<Combination>& combinations() const { return m_combinations; }
  /// Places that fit, the best first, a pixel or more from each other.
  /// @param nogoods  positions that are left out, by 6 mm. @param most  so many at most.
  std::vector<PlaceCandidate> candidates(Obstacles obstacles, const std::vector<Vec2>& nogoods,
                                         size_t most) const;
  /// Things to arrange that are in the way at a candidate.
  std::vector<size_t> blockers(const PlaceCandidate& candidate) const;

  /// PUT at a candidate, refined. @return why not; nullopt: it stands there.
  std::optional<Sentence> put(const PlaceCandidate& candidate, OperationResult& result);

  PlaceField field(const Combination& combination) const;

 private:
  friend class ConflictSearch;
  friend class PlaceCosts;
  friend class PlaceOrder;

  const ThingModel& model() const { return m_world.things()[m_thing]; }
  const std::string& name() const { return model().thing->object; }
  void combine();
  bool turns_are_free() const;
  std::vector<Rotation> turns(const Rest& rest) const;
  void clip(Combination& combination) const;
  void narrow(Combination& combination) const;
  ConvexRegion window(const Landing& landing, const Outline& outline) const;
  const Outline* partner(const Relation& relation) const;
  double cost(const Relation& relation, const Outline& outline) const;
  SightTrial sight_trial(const PlaceCandidate& candidate, Obstacles which) const;
  std::vector<ObjectId> obstacles(const Combination& combination, Obstacles which) const;
  size_t rank_of_turn(size_t turn) const;
  /// The other's zones as obstructions of the thing, and the other as one of the thing's zones.
  Obstructions zone_obstructions(const PlaceField& field, const Combination& combination,
                                 ObjectId other) const;
  /// Zones of this object that are free of the thing at each place, and its own of this object.
  std::vector<char> zones_clear_of(const PlaceField& field, const Combination& combination,
                                   ObjectId other) const;
  bool has_zones() const { return !m_world.arrangement().zones.empty(); }
  Vec2 refined(const PlaceCandidate& candidate) const;
  Rotation turned_to_face(const PlaceCandidate& candidate, const Vec2& at) const;
  std::optional<Sentence> push_to_contact(OperationResult& result);
  std::optional<Sentence> judge(const Combination& combination, const Rotation& rotation,
                                const OperationResult& result) const;
  std::optional<Sentence> judge_supports(const Combination& combination) const;
  std::optional<Sentence> judge_inside(const Object& thing) const;
  std::optional<Sentence> judge_distances(const Combination& combination) const;

  World& m_world;
  size_t m_thing;
  std::uint64_t m_seed;
  double m_temperature;
  double m_clearance;
  std::vector<const Relation*> m_relations;  // that can be judged: the partner stands
  std::vector<const Relation*> m_sights;     // hard ones of all that stands and this thing
  bool m_has_soft_sights = false;
  bool m_turns_are_free = false;  // any will do
  size_t m_num_turns = 0;
  std::map<std::string, Outline> m_partners;  // of these
  std::vector<Combination> m_combinations;
};

}  // namespace trivet
