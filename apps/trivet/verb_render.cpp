#include <iostream>

#include "apps/trivet/film_frames.h"
#include "apps/trivet/label_outputs.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/scene_input.h"
#include "apps/trivet/verbs.h"
#include "core/base/bad_input.h"
#include "core/io/atomic_file.h"
#include "core/io/overwrites.h"
#include "ops/files/layout/paths.h"

namespace trivet::apps {
namespace {

struct RenderArguments {
  std::string scene, picture;
  PictureRequest request;
  LabelArguments labels;
  FilmFrames film;
};

void render_picture(const RenderArguments& arguments, const CommonOptions& common) {
  PictureRequest request = arguments.request;
  request.num_threads = common.num_threads;
  request.device = common.detection().device;
  PictureMaker maker(request);
  const SceneFile file = read_scene_with_layout(arguments.scene, common);
  check_not_an_input(arguments.picture, model_files(file.layout, folder_of(arguments.scene)));
  clear_progress_line(common);
  write_file_atomically(arguments.picture, maker.png(file.scene));
  if (common.json)
    std::cout << "{\"picture\": " << json_string(arguments.picture)
              << ", \"device\": " << json_string(maker.device()) << "}\n";
}

VerbFiles files_of(const RenderArguments& arguments) {
  VerbFiles out{{{"", "", arguments.picture}}, label_files(arguments.labels), {arguments.scene}};
  out.outputs.push_back(arguments.film.file);
  out.folders = {arguments.labels.coco, arguments.labels.bop};
  return out;
}

// A film stands alone: the scene is a layout then.
int render_film(const RenderArguments& arguments, const CommonOptions& common) {
  if (!arguments.picture.empty() || arguments.labels.any())
    bad_input("--animation is asked for with other pictures; accepted: alone");
  if (arguments.labels.views.any())
    bad_input("--animation is asked for with --cameras or --dome; accepted: one --camera");
  PictureRequest request = arguments.request;
  request.num_threads = common.num_threads;
  request.device = common.detection().device;
  return render_film(arguments.scene, arguments.film, request, common);
}

int render(const RenderArguments& arguments, const CommonOptions& common) {
  if (!arguments.film.file.empty()) return render_film(arguments, common);
  if (arguments.picture.empty() && !arguments.labels.any())
    bad_input(
        "nothing is asked for; accepted: -o, --animation, --depth, --ids, --classes, --normals, "
        "--boxes, --coco or --bop");
  LabelArguments labels = arguments.labels;
  const bool many = labels.views.any();
  if (many) labels.picture = arguments.picture;
  if (labels.any()) {
    check_label_outputs(labels);
    PictureRequest request = arguments.request;
    request.num_threads = common.num_threads;
    request.device = common.detection().device;
    write_labels(arguments.scene, labels, request, common);
  }
  if (!arguments.picture.empty() && !many) render_picture(arguments, common);
  return 0;
}

}  // namespace

std::vector<Verb> add_render(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "render", "Render a picture or labelled images of a scene or a model, without a display");
  const auto arguments = std::make_shared<RenderArguments>();
  PictureRequest& request = arguments->request;
  verb->add_option("scene", arguments->scene,
                   "The scene, or any model file; for --animation a layout")
      ->required()
      ->type_name("SCENE");
  verb->add_option("-o,--output", arguments->picture,
                   "Write the picture, .png; for several cameras a name with {} for the number");
  verb->add_option("--width", request.width, "Width in pixels")->check(integer_from(1, 16384));
  verb->add_option("--height", request.height, "Height in pixels")->check(integer_from(1, 16384));
  verb->add_option("--samples", request.samples,
                   "Samples per pixel: 4 for a draft, 16 (default), 64 for print; with OpenGL, "
                   "views to average: 8, 32 (default), 128")
      ->check(integer_from(1, 4096));
  verb->add_option("--renderer", request.renderer,
                   "opengl; path: path tracing on the processor, glass included; auto: opengl on "
                   "graphics hardware. Labelled images always use path")
      ->check(one_of({"auto", "opengl", "path"}));
  verb->add_option("--bounces", request.bounces,
                   "Reflections that a path follows; 0: shadows and sky only, as with OpenGL")
      ->check(integer_from(0, 64));
  verb->add_option("--camera", request.camera,
                   "Eye and target (metres); default: a view from above that frames everything")
      ->expected(6)
      ->type_name("EX EY EZ TX TY TZ")
      ->check(number_from(-kMaxLength, kMaxLength));
  verb->add_option("--fov", request.fov_deg,
                   "Field of view from the lower to the upper edge (degrees)")
      ->check(number_from(1, 170));
  add_film_options(*verb, arguments->film);
  add_label_options(*verb, arguments->labels);
  return {{verb, [arguments, &common] { return render(*arguments, common); },
           "trivet render scene.glb -o scene.png --width 320 --height 240 --renderer path\n"
           "trivet render scene.glb --dome 4 --coco dataset --width 160 --height 120\n"
           "trivet render layout.json --animation film.webp --fps 4 --width 160 --height 120\n",
           true, [arguments] { return files_of(*arguments); }}};
}

}  // namespace trivet::apps
