#include <iostream>

#include "apps/trivet/outputs.h"
#include "apps/trivet/scene_input.h"
#include "apps/trivet/verbs.h"
#include "core/io/export.h"

namespace trivet::apps {
namespace {

struct RenderArguments {
  std::string scene, picture;
  PictureRequest request;
};

int render(const RenderArguments& arguments, const CommonOptions& common) {
  check_outputs({"", "", arguments.picture}, {arguments.scene});
  PictureMaker maker(arguments.request);
  const Scene scene = read_scene_or_model(arguments.scene, common);
  clear_progress_line(common);
  write_file_atomically(arguments.picture, maker.png(scene));
  if (common.json)
    std::cout << "{\"picture\": " << json_string(arguments.picture)
              << ", \"device\": " << json_string(maker.device()) << "}\n";
  return 0;
}

}  // namespace

Verb add_render(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb =
      app.add_subcommand("render", "Render a picture of a scene or a model, without a display");
  const auto arguments = std::make_shared<RenderArguments>();
  PictureRequest& request = arguments->request;
  verb->add_option("scene", arguments->scene, "The scene, or any model file")
      ->required()
      ->type_name("SCENE");
  verb->add_option("-o,--output", arguments->picture, "The picture, .png")->required();
  verb->add_option("--width", request.width, "Pixels")->check(integer_from(1, 16384));
  verb->add_option("--height", request.height, "Pixels")->check(integer_from(1, 16384));
  verb->add_option("--samples", request.samples,
                   "Number of views to average: 8 for a draft, 128 for print")
      ->check(integer_from(1, 4096));
  verb->add_option("--camera", request.camera,
                   "Eye and target, metres; default: a view from above that frames everything")
      ->expected(6)
      ->type_name("EX EY EZ TX TY TZ")
      ->check(number_from(-kMaxLength, kMaxLength));
  verb->add_option("--fov", request.fov_deg,
                   "Field of view, degrees from the lower to the upper edge")
      ->check(number_from(1, 170));
  return {verb, [arguments, &common] { return render(*arguments, common); }};
}

}  // namespace trivet::apps
