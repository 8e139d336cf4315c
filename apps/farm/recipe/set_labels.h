// Ids that hold over all scenes of a recipe: classes, and models of targets.
#pragma once

#include <string>
#include <vector>

#include "apps/farm/recipe/recipe.h"
#include "ops/files/json/text.h"

namespace trivet::farm {

/// A model whose objects are targets: of one size and up axis.
struct SetModel {
  int id = 0;         // obj_id of BOP, model_id of labels
  std::string group;  // that first has it; empty: of the objects before the groups
  LayoutObject object;
  Interval scale_range{1, 1};  // times the object's scale
  std::string symmetries;      // see RecipeModel

  bool has_one_size() const { return scale_range.low == scale_range.high; }
};

struct SetLabels {
  /// By class_id - 1: those of the recipe's "classes"; else those of targets, sorted, then others.
  std::vector<std::string> classes;
  /// In the order of the recipe. Without an "id" each has the smallest that is free.
  std::vector<SetModel> models;
};

/// Fixed objects and groups with "target": false are no targets.
SetLabels set_labels(const Recipe& recipe);

/// Class of an object in labels.
std::string class_of(const LayoutObject& object);

/// Reads "id" and "symmetries" of a model. @throws Error (BadInput).
void read_set_keys(const JsonPlace& place, RecipeModel& model);
/// "classes"; also checks them, and the ids of models, against the recipe that was read.
/// @throws Error (BadInput) naming the place.
void read_set_labels(const JsonPlace& root, Recipe& recipe);

/// The recipe without what only labels depend on: views, classes, targets, ids and symmetries.
std::string recipe_of_scenes(const std::string& canonical);

}  // namespace trivet::farm
