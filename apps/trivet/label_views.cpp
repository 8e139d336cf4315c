#include "apps/trivet/label_views.h"

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/picture/camera_dome.h"
#include "ops/files/json/input_text.h"
#include "ops/files/json/text.h"
#include "ops/files/labels/folders.h"

namespace trivet::apps {
namespace {

constexpr int kMaxViews = 1'000'000;

// {"cameras": [...]}
std::vector<LabelView> views_of_file(const std::string& file, const PictureRequest& request,
                                     const CommonOptions& common) {
  const std::string text =
      read_input_text(file, static_cast<std::uintmax_t>(common.max_file_mb * 1e6), TextKind::Json);
  const nlohmann::json document = parse_json(text, file);
  const JsonPlace root(document, file);
  root.expect_object({"cameras"}, {});
  return read_views(root.at("cameras"), request.width, request.height);
}

std::vector<LabelView> dome_views(const ViewArguments& arguments, const PictureRequest& request,
                                  const PictureScene& scene) {
  DomeOptions dome;
  dome.count = arguments.dome;
  dome.seed = arguments.dome_seed;
  dome.radius = arguments.dome_radius;
  dome.fov_deg = request.fov_deg;
  if (const auto& degrees = arguments.dome_elevation_deg; !degrees.empty())
    dome.lowest_deg = degrees[0], dome.highest_deg = degrees[1];
  std::vector<LabelView> views;
  views.reserve(static_cast<std::size_t>(dome.count));
  for (const Camera& camera : camera_dome(scene, double(request.width) / request.height, dome))
    views.push_back(
        {number_text(int(views.size())), pinhole_camera(camera, request.width, request.height)});
  return views;
}

}  // namespace

void add_view_options(CLI::App& app, ViewArguments& arguments) {
  const char* const group = "Cameras of labelled images";
  CLI::Option* const cameras =
      app.add_option("--cameras", arguments.cameras,
                     "Cameras from a JSON file, {\"cameras\": [{\"eye\": [x, y, z], \"target\": "
                     "[x, y, z], \"fov_deg\": 30}]} or with \"K\" and \"camera_from_world\"")
          ->type_name("FILE")
          ->group(group);
  app.add_option("--dome", arguments.dome, "Number of cameras around the scene, looking at it")
      ->check(integer_from(1, kMaxViews))
      ->excludes(cameras)
      ->group(group);
  app.add_option("--dome-seed", arguments.dome_seed, "Number that selects the cameras")
      ->group(group);
  app.add_option("--dome-radius", arguments.dome_radius,
                 "Distance from the scene's middle (metres); default: all of the scene is seen")
      ->check(number_from(1e-6, kMaxLength))
      ->group(group);
  app.add_option("--dome-elevation", arguments.dome_elevation_deg,
                 "Lowest and highest elevation (degrees); default: 15 75")
      ->expected(2)
      ->check(number_from(-90, 90))
      ->group(group);
}

std::vector<LabelView> label_views(const ViewArguments& arguments, const PictureRequest& request,
                                   const PictureScene& scene, const CommonOptions& common) {
  if (!arguments.cameras.empty()) return views_of_file(arguments.cameras, request, common);
  if (const auto& deg = arguments.dome_elevation_deg; !deg.empty() && deg[0] > deg[1])
    throw Error(Error::Kind::BadInput, "--dome-elevation: %1 to %2; accepted: the lowest first",
                figure(deg[0]), figure(deg[1]));
  if (arguments.dome > 0) return dome_views(arguments, request, scene);
  const double aspect = double(request.width) / request.height;
  const Camera camera = request.explicit_camera().value_or(automatic_camera(scene, aspect));
  return {{number_text(0), pinhole_camera(camera, request.width, request.height)}};
}

}  // namespace trivet::apps
