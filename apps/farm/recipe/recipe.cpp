#include "apps/farm/recipe/recipe.h"

#include <algorithm>
#include <functional>
#include <set>

#include "apps/farm/recipe/recipe_json.h"
#include "apps/farm/recipe/set_labels.h"
#include "apps/farm/recipe/sha256.h"
#include "apps/farm/recipe/views.h"
#include "core/base/nearest_name.h"
#include "ops/files/json/text.h"
#include "ops/files/layout/named_objects.h"

namespace trivet::farm {
namespace {

constexpr int kRecipeVersion = 1;
constexpr const char* kOwnKeys[] = {"trivet_recipe", "groups",      "then",  "accept", "on_refusal",
                                    "tries",         "max_motions", "views", "classes"};

/// The part that is a layout, read by the layout's reader: its complaints name the same places.
Layout read_base(const nlohmann::json& document, const std::string& file) {
  nlohmann::json layout = document;
  for (const char* const key : kOwnKeys) layout.erase(key);
  layout["trivet"] = 1;
  if (!layout.contains("objects")) layout["objects"] = nlohmann::json::array();
  return parse_layout(layout.dump(), file);
}

// "cup_12" of the group "cup".
bool is_member_name(const std::string& name, const std::string& group) {
  if (name.size() <= group.size() + 1 || name.compare(0, group.size(), group) != 0) return false;
  return name[group.size()] == '_' &&
         std::all_of(name.begin() + static_cast<long>(group.size()) + 1, name.end(),
                     [](unsigned char c) { return '0' <= c && c <= '9'; });
}

std::string first_members(const std::string& group) {
  std::string text = group;
  text.append("_0, ").append(group).append("_1, ...");
  return text;
}

/// Names that objects can be put on or in, at some point of the recipe.
class Known {
 public:
  explicit Known(const Layout& base) : m_floor(base.floor) {
    for (std::string& name : objects_after(base).names()) m_names.insert(std::move(name));
    m_taken = m_names;
    for (const LayoutObject& object : base.objects) m_taken.insert(object.name);
  }

  void add_group(const JsonPlace& place, const std::string& name) {
    for (const std::string& known : m_taken)
      if (known == name || is_member_name(known, name) ||
          (m_groups.count(known) && is_member_name(name, known)))
        place.refuse(say("a name that neither an object or group has, nor this group's objects: %1",
                         first_members(name)));
    m_names.insert(name);
    m_taken.insert(name);
    m_groups.insert(name);
  }
  void expect(const JsonPlace& place, const std::string& name, bool floor) const {
    if (m_names.count(name) || (floor && m_floor && name == "floor")) return;
    place.refuse(say("%1the name of an object or of a group above%2",
                     std::string(floor && m_floor ? "\"floor\", " : ""),
                     did_you_mean(name, {m_names.begin(), m_names.end()})));
  }
  void expect_group(const JsonPlace& place, const std::string& name) const {
    if (m_groups.count(name)) return;
    place.refuse(
        say("the name of a group%1", did_you_mean(name, {m_groups.begin(), m_groups.end()})));
  }

 private:
  bool m_floor;
  std::set<std::string> m_names, m_groups;
  std::set<std::string> m_taken;  // of m_names, and of objects that are renamed or deleted later
};

void check_place(const JsonPlace& place, const RecipeGroup& group, const Known& known) {
  if (const auto* on = std::get_if<PutOn>(&group.place))
    for (const std::string& name : on->on) known.expect(place.at("on"), name, true);
  if (const auto* in = std::get_if<PutIn>(&group.place))
    for (const std::string& name : in->in) known.expect(place.at("in"), name, false);
}

OnRefusal read_on_refusal(const JsonPlace& place) {
  if (place.value() == "keep") return OnRefusal::Keep;
  if (place.value() == "retry") return OnRefusal::Retry;
  if (place.value() == "drop") return OnRefusal::Drop;
  place.refuse("\"keep\", \"retry\" or \"drop\"");
}

void check_top(const JsonPlace& root) {
  root.expect_object({"trivet_recipe"}, {"floor", "material", "floor_material", "settle", "objects",
                                         "operations", "groups", "then", "accept", "on_refusal",
                                         "tries", "max_motions", "views", "classes"});
  const JsonPlace version = root.at("trivet_recipe");
  if (!version.value().is_number() || version.value() != kRecipeVersion)
    version.refuse(say("%1, the version of the recipe format", kRecipeVersion));
}

void read_groups(const JsonPlace& root, Recipe& recipe) {
  Known known(recipe.base);
  if (const auto groups = root.find("groups"))
    for (const JsonPlace& item : groups->items()) {
      recipe.groups.push_back(read_group(item));
      check_place(item, recipe.groups.back(), known);
      known.add_group(item.at("name"), recipe.groups.back().name);
    }
  if (const auto then = root.find("then"))
    for (const JsonPlace& item : then->items()) {
      recipe.then.push_back(read_move(item));
      if (!recipe.then.back().group.empty())
        known.expect_group(item.at("group"), recipe.then.back().group);
    }
}

// Objects that nothing puts into the scene. An arrangement may put any.
std::set<std::string> never_placed(const Layout& base) {
  std::set<std::string> out;
  for (const LayoutObject& object : base.objects)
    if (!object.pose) out.insert(object.name);
  for (const Operation& operation : base.operations) {
    if (std::holds_alternative<ArrangeOperation>(operation)) return {};
    out.erase(object_name(operation));
  }
  return out;
}

void check_something_is_made(const JsonPlace& root, const Recipe& recipe) {
  if (recipe.base.objects.empty() && recipe.groups.empty())
    root.fail("neither \"objects\" nor \"groups\"; accepted: at least one object or group");
  const std::set<std::string> absent = never_placed(recipe.base);
  for (size_t i = 0; i < recipe.base.objects.size(); ++i)
    if (const LayoutObject& object = recipe.base.objects[i];
        object.fixed && absent.count(object.name))
      root.at("objects").items()[i].fail(
          say("\"%1\" is fixed and nothing puts it into the scene; accepted: with \"position\"",
              object.name));
  bool any = absent.size() < recipe.base.objects.size() || !recipe.base.operations.empty();
  for (size_t i = 0; i < recipe.groups.size(); ++i) {
    const RecipeGroup& group = recipe.groups[i];
    any = any || group.count.high > 0;
    const auto* const on = std::get_if<PutOn>(&group.place);
    const auto* const in = std::get_if<PutIn>(&group.place);
    const std::vector<std::string> names = on ? on->on : in ? in->in : std::vector<std::string>();
    const auto is_absent = [&](const std::string& name) { return absent.count(name) > 0; };
    if (!names.empty() && std::all_of(names.begin(), names.end(), is_absent))
      root.at("groups")
          .items()[i]
          .at(on ? "on" : "in")
          .fail(say(
              "\"%1\" is never in the scene; accepted: an object with a \"position\", or with an "
              "operation that puts it",
              names.front()));
  }
  if (!any)
    root.fail("all groups have the count 0: no scene has an object; accepted: a count from 1");
}

void rename_models(nlohmann::json& document, const char* list,
                   const std::function<std::string(const std::string&)>& rename) {
  if (!document.contains(list)) return;
  for (nlohmann::json& item : document[list])
    for (const char* const key : {"model", "collision"})
      if (item.contains(key)) item[key] = rename(item[key].get<std::string>());
}

}  // namespace

Recipe parse_recipe(const std::string& text, const std::string& file) {
  const nlohmann::json document = parse_json(text, file);
  const JsonPlace root(document, file);
  check_top(root);
  Recipe recipe;
  recipe.base = read_base(document, file);
  read_groups(root, recipe);
  read_set_labels(root, recipe);
  if (const auto accept = root.find("accept")) recipe.accept = read_acceptance(*accept);
  if (const auto rule = root.find("on_refusal")) recipe.on_refusal = read_on_refusal(*rule);
  if (const auto tries = root.find("tries")) {
    if (recipe.on_refusal != OnRefusal::Retry)
      tries->fail("there is no \"on_refusal\": \"retry\" for it");
    recipe.tries = read_integer(*tries, 1, kMaxTries);
  }
  if (const auto most = root.find("max_motions"))
    recipe.max_motions = read_integer(*most, 1, 1'000'000'000);
  if (const auto views = root.find("views")) read_view_wishes(*views);  // a mistake is told at once
  check_something_is_made(root, recipe);
  return recipe;
}

std::string canonical_recipe(const std::string& text, const std::string& file,
                             const std::function<std::string(const std::string&)>& rename) {
  nlohmann::json document = parse_json(text, file);
  rename_models(document, "objects", rename);
  rename_models(document, "operations", rename);
  if (document.contains("groups"))
    for (nlohmann::json& group : document["groups"]) rename_models(group, "models", rename);
  if (document.contains("views")) rename_look_files(document["views"], rename);
  return document.dump();
}

std::vector<std::string> models_of(const Recipe& recipe) {
  std::set<std::string> out;
  const auto add = [&](const LayoutObject& object) {
    out.insert(object.model);
    if (!object.collision.empty()) out.insert(object.collision);
  };
  for (const LayoutObject& object : recipe.base.objects) add(object);
  for (const Operation& operation : recipe.base.operations)
    if (const auto* append = std::get_if<AppendOperation>(&operation)) out.insert(append->model);
  for (const RecipeGroup& group : recipe.groups)
    for (const RecipeModel& model : group.models) add(model.object);
  return {out.begin(), out.end()};
}

PhiloxKey recipe_key(const std::string& canonical, std::uint64_t seed) {
  const std::string scenes = recipe_of_scenes(canonical);
  const Digest d = sha256(sha256_hex(scenes) + " " + std::to_string(seed));
  const auto word = [&](size_t at) {
    return static_cast<std::uint32_t>(d[at]) | static_cast<std::uint32_t>(d[at + 1]) << 8 |
           static_cast<std::uint32_t>(d[at + 2]) << 16 |
           static_cast<std::uint32_t>(d[at + 3]) << 24;
  };
  return {word(0), word(4)};
}

}  // namespace trivet::farm
