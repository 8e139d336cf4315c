// Scene k of a recipe: a function of the recipe, the key of its decisions, and k.
#pragma once

#include <map>
#include <string>

#include "apps/farm/recipe/recipe.h"
#include "ops/files/layout/scene_of_layout.h"

namespace trivet::farm {

struct MadeScene {
  /// Cancelled or OutOfTime: stopped by SceneSource::context; nothing else means anything then.
  OperationResult::Status end = OperationResult::Status::Ok;
  bool accepted = false;
  std::string reason;                           // why it was not; empty if it was
  int attempt = 0;                              // that this is, of Acceptance::attempts
  LayoutRun run;                                // its operations, the refused ones too; no times
  Layout layout;                                // its objects, and the operations that were done
  std::map<std::string, std::string> left_out;  // objects that are out of the scene, and why
};

/// Parts that all scenes of a batch share. Refers to them; they outlive it.
struct SceneSource {
  const Recipe& recipe;
  const LoadedModels& models;  // all that models_of(recipe) and their tessellations ask for
  PhiloxKey key;
  /// Its time is that of a whole scene, all attempts together; checked between motions.
  RunContext context = {};
};

/// Draws scenes for k until one is accepted or there were Acceptance::attempts: the last one.
/// @param k  0 and up.
/// @throws Error (BadInput) for objects that reach too far; what operations throw.
MadeScene make_scene(const SceneSource& source, std::uint64_t k);

}  // namespace trivet::farm
