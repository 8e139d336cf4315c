#include "apps/trivet/label_views.h"

#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/picture/camera_dome.h"
#include "ops/files/json/input_text.h"
#include "ops/files/json/json_text.h"
#include "ops/files/labels/folders.h"

namespace trivet::apps {
namespace {

constexpr int kMaxViews = 1'000'000;

int pixels(const JsonPlace& place, const char* key, int otherwise) {
  const auto value = place.find(key);
  if (!value) return otherwise;
  const double number = value->number(1, kMaxPictureSide);
  if (number != std::floor(number)) value->refuse("whole numbers from 1 to 16384");
  return static_cast<int>(number);
}

Vec3 point(const JsonPlace& place) {
  const std::vector<double> v = place.numbers(3, -kMaxLength, kMaxLength);
  return {v[0], v[1], v[2]};
}

PinholeCamera aimed_camera(const JsonPlace& place, int width, int height) {
  place.expect_object({"eye", "target"}, {"name", "width", "height", "up", "fov_deg"});
  Camera camera;
  camera.eye = point(place.at("eye")), camera.target = point(place.at("target"));
  if (const auto up = place.find("up")) camera.up = point(*up);
  if (const auto fov = place.find("fov_deg")) camera.fov_deg = fov->number(1, 170);
  return pinhole_camera(camera, width, height);
}

std::vector<std::vector<double>> rows(const JsonPlace& place, std::size_t least, std::size_t most,
                                      std::size_t columns) {
  std::vector<std::vector<double>> out;
  for (const JsonPlace& row : place.items()) out.push_back(row.numbers(columns));
  if (out.size() < least || out.size() > most)
    place.refuse("a matrix of " + std::to_string(least) + " rows");
  return out;
}

PinholeCamera measured_camera(const JsonPlace& place, int width, int height) {
  place.expect_object({"K", "camera_from_world"}, {"name", "width", "height", "convention"});
  const auto k = rows(place.at("K"), 3, 3, 3);
  const auto m = rows(place.at("camera_from_world"), 3, 4, 4);
  if (k[0][1] != 0 || k[1][0] != 0 || k[2] != std::vector<double>{0, 0, 1})
    place.at("K").refuse("[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]");
  PinholeCamera camera;
  camera.width = width, camera.height = height;
  camera.fx = k[0][0], camera.fy = k[1][1], camera.cx = k[0][2], camera.cy = k[1][2];
  Vec3 translation;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) camera.camera_from_world(r, c) = m[r][c];
    translation[r] = m[r][3];
  }
  camera.eye = -(camera.camera_from_world.transpose() * translation);
  return camera;
}

LabelView read_view(const JsonPlace& place, const std::string& name,
                    const PictureRequest& request) {
  if (!place.value().is_object()) place.refuse("an object");
  const int width = pixels(place, "width", request.width);
  const int height = pixels(place, "height", request.height);
  LabelView view{name, {}};
  if (const auto given = place.find("name")) view.name = given->text();
  if (view.name.find('/') != std::string::npos || view.name == "." || view.name == "..")
    place.at("name").refuse("a name without slashes, as it becomes a part of file names");
  try {
    view.camera = place.find("K") ? measured_camera(place, width, height)
                                  : aimed_camera(place, width, height);
    check_camera(view.camera);
  } catch (const Error& error) {
    const std::string what = error.what(), where = place.where();
    if (what.rfind(where, 0) == 0) throw;
    place.fail(what);
  }
  return view;
}

}  // namespace

void add_view_options(CLI::App& app, ViewArguments& arguments) {
  const char* const group = "Cameras of labelled images";
  CLI::Option* const cameras =
      app.add_option("--cameras", arguments.cameras,
                     "Cameras of a JSON file, {\"cameras\": [{\"eye\": [x, y, z], \"target\": "
                     "[x, y, z], \"fov_deg\": 30}]} or with \"K\" and \"camera_from_world\"")
          ->type_name("FILE")
          ->group(group);
  app.add_option("--dome", arguments.dome, "This many cameras around the scene, looking at it")
      ->check(integer_from(1, kMaxViews))
      ->excludes(cameras)
      ->group(group);
  app.add_option("--dome-seed", arguments.dome_seed, "Another seed, other cameras")->group(group);
  app.add_option("--dome-radius", arguments.dome_radius,
                 "Metres from the scene's middle; default: so that all of it is seen")
      ->check(number_from(1e-6, kMaxLength))
      ->group(group);
  app.add_option("--dome-elevation", arguments.dome_elevation_deg,
                 "Lowest and highest elevation, degrees; default: 15 75")
      ->expected(2)
      ->check(number_from(-90, 90))
      ->group(group);
}

std::vector<LabelView> read_views(const std::string& text, const std::string& file,
                                  const PictureRequest& request) {
  const nlohmann::json document = parse_json(text, file);
  const JsonPlace root(document, file);
  root.expect_object({"cameras"}, {});
  std::vector<LabelView> views;
  std::set<std::string> names;
  for (const JsonPlace& place : root.at("cameras").items()) {
    views.push_back(read_view(place, number_text(int(views.size())), request));
    if (!names.insert(views.back().name).second)
      place.fail("\"" + views.back().name + "\" is already the name of a camera");
  }
  if (views.empty()) root.at("cameras").refuse("at least one camera");
  return views;
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

std::vector<LabelView> label_views(const ViewArguments& arguments, const PictureRequest& request,
                                   const PictureScene& scene, const CommonOptions& common) {
  if (!arguments.cameras.empty())
    return read_views(
        read_input_text(arguments.cameras, static_cast<std::uintmax_t>(common.max_file_mb * 1e6),
                        TextKind::Json),
        arguments.cameras, request);
  if (const auto& deg = arguments.dome_elevation_deg; !deg.empty() && deg[0] > deg[1])
    throw Error(Error::Kind::BadInput, "--dome-elevation: " + short_number(deg[0]) + " to " +
                                           short_number(deg[1]) + "; accepted: the lowest first");
  if (arguments.dome > 0) return dome_views(arguments, request, scene);
  const double aspect = double(request.width) / request.height;
  const Camera camera = request.explicit_camera().value_or(automatic_camera(scene, aspect));
  return {{number_text(0), pinhole_camera(camera, request.width, request.height)}};
}

}  // namespace trivet::apps
