// Relations that rays decide in the scene: under, in view, in reach.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/arrange/world.h"

namespace trivet {

/// A scene as rays see it: with one of the things where it may come to stand.
struct SightTrial {
  const World& world;
  int thing = -1;               // index; -1: the scene as it is
  Pose pose;                    // of the thing
  bool immovable_only = false;  // others of the things to arrange hide nothing
};

/// Cost in tolerances of a relation of sight whose objects stand, or are the thing of the trial.
/// Under: rays up from a grid on a's outline. View: rays from the eye to a grid on the rectangle
/// that a's box is seen in; those that meet a count. Reach: the shortest of these to a that nothing
/// else cuts off, the viewer itself left out. At most relations::kMostSightCost.
double sight_cost(const SightTrial& trial, const Relation& relation);

/// The same decision at one pose of the thing after the other, sooner: what stands is looked up
/// once, and rays are cast until it is certain.
class SightJudge {
 public:
  SightJudge(const SightTrial& trial, const Relation& relation);
  ~SightJudge();
  SightJudge(const SightJudge&) = delete;
  SightJudge& operator=(const SightJudge&) = delete;
  /// sight_cost() of the trial with the thing there is 1 at most.
  bool holds_at(const Pose& pose);

 private:
  std::unique_ptr<class Eyes> m_eyes;
};

/// Things to arrange that rays of the relation meet before a; neither of its objects.
std::vector<size_t> things_between(const SightTrial& trial, const Relation& relation);

/// Why a hard relation of sight of what stands does not hold; nullopt: all do.
std::optional<Sentence> broken_sight(const World& world);

/// Hard relations of sight that can be judged in the trial: all their objects stand then.
std::vector<const Relation*> sights_of(const SightTrial& trial);

}  // namespace trivet
