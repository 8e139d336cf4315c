#include "apps/farm/recipe/set_labels.h"

#include <algorithm>
#include <map>
#include <set>

#include "apps/farm/recipe/recipe_json.h"
#include "core/base/limits.h"
#include "ops/files/labels/labelled_scene.h"

namespace trivet::farm {
namespace {

constexpr int kMaxModelId = 999'999;  // six digits in file names
constexpr size_t kMaxSymmetries = 1000;

bool is_same_model(const SetModel& a, const SetModel& b) {
  return a.object.model == b.object.model && a.object.up == b.object.up &&
         a.object.scale == b.object.scale && a.object.tessellation == b.object.tessellation &&
         a.scale_range.low == b.scale_range.low && a.scale_range.high == b.scale_range.high;
}

/// Models of targets, each once; those without an id have 0.
std::vector<SetModel> models_of_targets(const Recipe& recipe) {
  std::vector<SetModel> out;
  const auto add = [&](const SetModel& model) {
    const auto same = [&](const SetModel& other) { return is_same_model(model, other); };
    const auto found = std::find_if(out.begin(), out.end(), same);
    if (found == out.end())
      out.push_back(model);
    else if (found->id == 0)
      found->id = model.id;
  };
  for (const LayoutObject& object : recipe.base.objects)
    if (!object.fixed) add({0, "", object, {1, 1}, ""});
  for (const Operation& operation : recipe.base.operations)
    if (const auto* append = std::get_if<AppendOperation>(&operation); append && !append->fixed) {
      LayoutObject object;
      object.model = append->model, object.scale = append->scale, object.up = append->up;
      object.tessellation = append->tessellation;
      add({0, "", object, {1, 1}, ""});
    }
  for (const RecipeGroup& group : recipe.groups)
    for (const RecipeModel& model : group.models)
      if (group.target)
        add({model.id.value_or(0), group.name, model.object, group.scale_range, model.symmetries});
  return out;
}

void give_free_ids(std::vector<SetModel>& models) {
  std::set<int> taken;
  for (const SetModel& model : models) taken.insert(model.id);
  int next = 1;
  for (SetModel& model : models) {
    if (model.id != 0) continue;
    while (!taken.insert(next).second) ++next;
    model.id = next;
  }
}

/// Classes of targets, and all of them.
struct Classes {
  std::set<std::string> targets, all;

  explicit Classes(const Recipe& recipe) {
    for (const LayoutObject& object : recipe.base.objects) add(class_of(object), !object.fixed);
    for (const Operation& operation : recipe.base.operations)
      if (const auto* append = std::get_if<AppendOperation>(&operation))
        add(class_of_model(append->model), !append->fixed);
    for (const RecipeGroup& group : recipe.groups)
      for (const RecipeModel& model : group.models) add(class_of(model.object), group.target);
  }
  void add(const std::string& name, bool target) {
    all.insert(name);
    if (target) targets.insert(name);
  }
};

void check_classes(const JsonPlace& place, const Recipe& recipe) {
  const std::set<std::string> listed(recipe.classes.begin(), recipe.classes.end());
  if (listed.size() != recipe.classes.size()) place.fail("a class comes twice");
  for (const std::string& name : Classes(recipe).all)
    if (!listed.count(name))
      place.fail(say("\"%1\" is missing, the class of an object; accepted: all classes", name));
}

// One id for one model, and one model for one id.
void check_ids(const JsonPlace& groups, const Recipe& recipe) {
  std::map<int, SetModel> known;
  for (size_t g = 0; g < recipe.groups.size(); ++g)
    for (size_t m = 0; m < recipe.groups[g].models.size(); ++m) {
      const RecipeModel& entry = recipe.groups[g].models[m];
      if (!entry.id || !recipe.groups[g].target) continue;
      const SetModel model{*entry.id, "", entry.object, recipe.groups[g].scale_range, ""};
      const JsonPlace place = groups.items()[g].at("models").items()[m].at("id");
      for (const auto& [id, other] : known)
        if (is_same_model(model, other) != (id == model.id))
          place.refuse("one id for each model, and other ids for others");
      known.emplace(model.id, model);
    }
}

std::vector<double> checked_numbers(const JsonPlace& place, size_t count) {
  return place.numbers(count, -kMaxLength, kMaxLength);
}

void check_symmetries(const JsonPlace& place) {
  place.expect_object({}, {"continuous", "discrete"});
  size_t count = 0;
  if (const auto axes = place.find("continuous"))
    for (const JsonPlace& axis : axes->items()) {
      axis.expect_object({"axis", "offset"}, {});
      const std::vector<double> a = checked_numbers(axis.at("axis"), 3);
      checked_numbers(axis.at("offset"), 3);
      if (a[0] == 0 && a[1] == 0 && a[2] == 0) axis.at("axis").refuse("a direction, not zero");
      ++count;
    }
  if (const auto matrices = place.find("discrete"))
    for (const JsonPlace& matrix : matrices->items()) checked_numbers(matrix, 16), ++count;
  if (count > kMaxSymmetries)
    place.fail(say("%1 symmetries; accepted: at most %2", count, kMaxSymmetries));
}

}  // namespace

std::string class_of(const LayoutObject& object) {
  return object.class_name.empty() ? class_of_model(object.model) : object.class_name;
}

SetLabels set_labels(const Recipe& recipe) {
  SetLabels out;
  out.models = models_of_targets(recipe);
  give_free_ids(out.models);
  out.classes = recipe.classes;
  if (!out.classes.empty()) return out;
  const Classes classes(recipe);
  out.classes.assign(classes.targets.begin(), classes.targets.end());
  for (const std::string& name : classes.all)
    if (!classes.targets.count(name)) out.classes.push_back(name);
  return out;
}

void read_set_keys(const JsonPlace& place, RecipeModel& model) {
  if (const auto id = place.find("id")) model.id = read_integer(*id, 1, kMaxModelId);
  if (const auto symmetries = place.find("symmetries")) {
    check_symmetries(*symmetries);
    model.symmetries = symmetries->value().dump();
  }
}

void read_set_labels(const JsonPlace& root, Recipe& recipe) {
  if (const auto groups = root.find("groups")) check_ids(*groups, recipe);
  const auto classes = root.find("classes");
  if (!classes) return;
  for (const JsonPlace& name : classes->items()) recipe.classes.push_back(name.text());
  if (recipe.classes.empty()) classes->refuse("an array of at least one name");
  check_classes(*classes, recipe);
}

std::string recipe_of_scenes(const std::string& canonical) {
  nlohmann::json recipe = nlohmann::json::parse(canonical);
  recipe.erase("views");
  recipe.erase("classes");
  if (recipe.contains("groups"))
    for (nlohmann::json& group : recipe["groups"]) {
      group.erase("target");
      for (nlohmann::json& model : group["models"]) model.erase("id"), model.erase("symmetries");
    }
  return recipe.dump();
}

}  // namespace trivet::farm
