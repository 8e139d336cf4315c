// Recipes: from what, and how, random scenes are made.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/farm/recipe/decisions.h"
#include "apps/farm/recipe/look.h"
#include "ops/files/layout/layout.h"
#include "ops/operations/drape.h"
#include "ops/operations/put.h"

namespace trivet::farm {

/// Drawn for each object; what is not given is that of the model's material and geometry.
struct PhysicsRanges {
  std::optional<Interval> friction, density, restitution;
  std::optional<Interval> kilograms;
};

/// One of the models that objects of a group are made of.
struct RecipeModel {
  LayoutObject object;  // without name and pose
  PhysicsRanges physics;
  double weight = 1;       // how often, beside the others
  std::optional<int> id;   // in data sets
  std::string symmetries;  // JSON {"continuous", "discrete"} as BOP has them, metres; empty: none
};

enum class RotationRule { Yaw, Any, Given };

/// Put where there is room on an object, or on one of a group that is there.
struct PutOn {
  std::vector<std::string> on;     // objects, groups or "floor": one of them
  double keep = 0;                 // distance to all but the support, metres
  std::vector<Vec2> region;        // see PlaceOptions; none: anywhere
  bool region_of_support = false;  // in the frame of the support's pose; else in the world's
};
/// Let fall into an object, above a random point of its box; it counts if it stays in the box.
struct PutIn {
  std::vector<std::string> in;
  double above = 0.1;  // metres from the container's top to the object's origin
};
/// Let fall over a random point of a disc.
struct PutHeap {
  Vec2 centre = Vec2::Zero();
  double radius = 0.1;            // metres
  double height = 1, rise = 0.1;  // z of the first object's origin; what each further one adds
};
using PlaceRule = std::variant<PutOn, PutIn, PutHeap>;

struct RecipeGroup {
  std::string name;  // objects are NAME_0, NAME_1, ...
  std::vector<RecipeModel> models;
  Counts count{1, 1};
  Interval scale_range{1, 1};  // times the model's scale
  RotationRule rotation = RotationRule::Yaw;
  Rotation given;
  PlaceRule place;
  int tries = kTriesOfPut;            // starts of a PUT that lets an object fall, see PutOperation
  bool target = true;                 // of data sets; else its objects are distractors
  std::optional<SurfaceRanges> look;  // in pictures
};

/// Random operations at the end.
struct RecipeMove {
  enum class Kind { Push, Turn, Drape };
  Kind kind = Kind::Push;
  std::string group;  // empty: of all objects that are not fixed
  Counts count{1, 1};
  Interval distance;     // of pushes, metres, in any direction
  Interval angle_deg;    // of turns about the contact's normal
  DrapeOperation sheet;  // over each object of the group, at a random angle: NAME_0, NAME_1, ...
};

/// Conditions on a scene beside the exact check (no interpenetration, all at rest).
struct Acceptance {
  int min_objects = 0;             // of the groups, in the scene
  bool stable = true;              // as a whole, see ops/stability
  double min_margin = 0;           // metres, see Stability::margin
  std::optional<int> max_refused;  // operations
  int attempts = 1;                // scenes drawn for one k until one is accepted
};

/// Consequence of an object that cannot be put.
enum class OnRefusal {
  Keep,   // the scene goes on without it
  Retry,  // it is tried elsewhere, then left out
  Drop,   // the scene is refused
};

struct Recipe {
  Layout base;  // objects and operations before the groups
  std::vector<RecipeGroup> groups;
  std::vector<RecipeMove> then;
  Acceptance accept;
  OnRefusal on_refusal = OnRefusal::Keep;
  int tries = 3;  // of an object, with OnRefusal::Retry
  int max_motions = 5000;
  std::vector<std::string>
      classes;  // of labels, in the order of their ids; empty: see set_labels.h
};

inline constexpr int kMaxObjectsOfGroup = 100'000, kMaxTries = 1000;

/// Reads a recipe strictly: what recipe.schema.json does not have is an error, and so are names
/// that come twice or that nothing has. Models are not opened.
/// @param file  name for messages.
/// @throws Error (BadInput) naming the file, the place as a JSON pointer, the value and what is
///   accepted.
Recipe parse_recipe(const std::string& text, const std::string& file);

/// The recipe's text with other names of its models and environments, keys sorted, no spaces: equal
/// recipes are equal bytes.
/// @param rename  called with each model's path.
std::string canonical_recipe(const std::string& text, const std::string& file,
                             const std::function<std::string(const std::string&)>& rename);

/// Paths of all models, each once, sorted.
std::vector<std::string> models_of(const Recipe& recipe);

/// Key of all random decisions: of the canonical recipe, whose models' names have their SHA-256,
/// without its views, and the seed: other cameras see the same scenes.
PhiloxKey recipe_key(const std::string& canonical, std::uint64_t seed);

}  // namespace trivet::farm
