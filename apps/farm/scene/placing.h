// Places of a recipe's objects, by its rules, in the scene as it is. Private.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/farm/recipe/recipe.h"
#include "core/scene/scene.h"
#include "ops/base/context.h"
#include "ops/base/options.h"
#include "ops/base/outcome.h"

namespace trivet::farm {

/// Names of the objects of each group.
using Members = std::map<std::string, std::vector<std::string>>;

struct Placing {
  PutOperation put;
  std::optional<ObjectId> container;  // in whose box its centre of mass has to come to rest
};

/// @param name  of the object, out of the scene yet.
/// @return nullopt: none of what it could be put on is in the scene.
std::optional<Placing> draw_placing(const Scene& scene, const RecipeGroup& group,
                                    const Members& members, const std::string& name,
                                    const Rotation& rotation, Decision& decision);

struct PutResult {
  OperationResult result;
  std::string reason;  // of a refusal
};
/// Puts it; refused where it comes to rest outside its container. Then the scene is as it was.
PutResult put_by(Scene& scene, const Placing& placing, const SettleOptions& settle,
                 const RunContext& context);

/// Names of what the rule puts objects on or in, for messages.
/// Over the middle of an object, clear of all that a sheet of this radius could begin in.
Vec3 start_over(const Scene& scene, const std::string& name, double radius);

std::string support_names(const RecipeGroup& group);

}  // namespace trivet::farm
