// Scenes of other programs as scenes of Trivet. Start here.
#pragma once

#include <vector>

#include "core/io/foreign/scene.h"
#include "core/scene/scene.h"

namespace trivet {

/// Kinds of bodies and of the floor, and the rules between them.
struct PairTable {
  std::vector<PairKind> kinds;  // by body
  PairKind floor_kind = 0;
  std::shared_ptr<const PairRules> rules;
};

/// The part of a foreign scene that can be judged, and how to get back.
struct JudgedScene {
  Scene scene;
  std::vector<std::optional<ObjectId>> ids;  // by body; nothing: it is the floor
  double lift = 0;       // metres; height in the scene = height in the file + lift
  double clearance = 0;  // metres that the file's margins ask for; 0: none
  std::vector<Sentence> notes;
  std::optional<PairTable> moving_links;  // the rules while links move; nothing: there are none
};

/// Every body becomes an object, of all its colliders. The first horizontal plane becomes the
/// floor, other planes become large slabs. Pairs collide and rub as the engine has it; pairs of
/// fixed objects pass. @throws Error (BadInput): too coarse for exact judgement, or beyond limits.
JudgedScene judged_scene(const ForeignScene& foreign);

/// The pose in the file of an object's pose in the scene, and back.
Pose pose_in_file(const JudgedScene& judged, Pose pose);

}  // namespace trivet
