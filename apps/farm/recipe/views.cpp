#include "apps/farm/recipe/views.h"

#include "apps/farm/recipe/recipe_json.h"
#include "core/base/limits.h"

namespace trivet::farm {
namespace {

constexpr int kMaxCameras = 1000;  // of a scene

void read_dome(const JsonPlace& place, DomeOptions& dome, DomeRanges& ranges) {
  place.expect_object({}, {"count", "radius", "elevation_deg", "fov_deg", "roll_deg", "around"});
  if (const auto count = place.find("count")) dome.count = read_integer(*count, 1, kMaxCameras);
  if (const auto radius = place.find("radius"))
    ranges.radius = read_interval(*radius, 1e-6, kMaxLength);
  if (const auto fov = place.find("fov_deg")) ranges.fov_deg = read_interval(*fov, 1, 170);
  if (const auto roll = place.find("roll_deg")) ranges.roll_deg = read_interval(*roll, -170, 170);
  if (const auto elevation = place.find("elevation_deg")) {
    const Interval range = read_interval(*elevation, -90, 90);
    dome.lowest_deg = range.low, dome.highest_deg = range.high;
  }
  if (const auto around = place.find("around")) {
    ranges.around_targets = around->value() == "targets";
    if (!ranges.around_targets && around->value() != "scene")
      around->refuse("\"scene\" or \"targets\"");
  }
}

void read_images(const JsonPlace& place, Views& views) {
  views.picture = views.depth = views.instances = false;
  bool any = false;
  for (const JsonPlace& item : place.items()) {
    const std::string name = item.text();
    bool* const wanted = name == "picture"     ? &views.picture
                         : name == "depth"     ? &views.depth
                         : name == "instances" ? &views.instances
                         : name == "classes"   ? &views.classes
                         : name == "normals"   ? &views.normals
                                               : nullptr;
    if (!wanted) item.refuse("\"picture\", \"depth\", \"instances\", \"classes\" or \"normals\"");
    any = *wanted = true;
  }
  if (!any) place.refuse("at least one image");
}

}  // namespace

Views read_view_wishes(const JsonPlace& place) {
  place.expect_object({}, {"width", "height", "cameras", "dome", "samples", "bounces", "depth_unit",
                           "images", "look"});
  Views out;
  if (const auto width = place.find("width")) out.width = read_pixels(*width);
  if (const auto height = place.find("height")) out.height = read_pixels(*height);
  if (place.find("cameras") && place.find("dome"))
    place.at("dome").fail("there are \"cameras\" beside it; accepted: one of them");
  if (const auto cameras = place.find("cameras"))
    out.cameras = read_views(*cameras, out.width, out.height);
  if (const auto dome = place.find("dome")) read_dome(*dome, out.dome, out.ranges);
  if (const auto samples = place.find("samples")) out.samples = read_integer(*samples, 1, 4096);
  if (const auto bounces = place.find("bounces")) out.bounces = read_integer(*bounces, 0, 64);
  if (const auto unit = place.find("depth_unit")) out.depth_unit = unit->number(1e-9, 1e9);
  if (const auto images = place.find("images")) read_images(*images, out);
  if (const auto look = place.find("look")) out.look = read_look(*look);
  return out;
}

void rename_environments(nlohmann::json& views,
                         const std::function<std::string(const std::string&)>& rename) {
  if (!views.contains("look") || !views["look"].contains("environments")) return;
  for (nlohmann::json& file : views["look"]["environments"]) file = rename(file.get<std::string>());
}

std::string views_text(const std::string& text, const std::string& file) {
  const nlohmann::json document = parse_json(text, file);
  const JsonPlace root(document, file);
  if (!document.is_object() || !root.find("views"))
    root.fail("has no \"views\"; accepted: a recipe with them, or {\"views\": {...}}");
  if (!root.find("trivet_recipe")) root.expect_object({"views"}, {});
  read_view_wishes(root.at("views"));
  return document.at("views").dump();
}

}  // namespace trivet::farm
