#include <iostream>

#include "apps/farm/batch/pictures.h"
#include "apps/farm/batch/source.h"
#include "apps/farm/batch/stop_signals.h"
#include "apps/trivet/in_child.h"
#include "apps/trivet/picture.h"
#include "apps/trivet/verb_batch_parts.h"
#include "core/base/bad_input.h"
#include "core/picture/png.h"
#include "ops/files/json/input_text.h"

namespace trivet::apps {
namespace {

using namespace trivet::farm;

struct PictureArguments {
  std::string scenes, views, shard, format = "tar", renderer = "path", bop, coco;
  std::uint64_t per_unit = 0;
  BatchOptions options;
};

/// Which of --out, --bop and --coco.
UnitFormat form_of(PictureArguments& a) {
  const int num_given = !a.options.out.empty() + !a.bop.empty() + !a.coco.empty();
  if (num_given != 1)
    bad_input("batch pictures: %1 of --out, --bop and --coco; accepted: one", num_given);
  if (a.options.out.empty()) a.options.out = a.bop + a.coco;
  if (!a.bop.empty()) return UnitFormat::Bop;
  if (!a.coco.empty()) return UnitFormat::Coco;
  return a.format == "dir" ? UnitFormat::Dir : UnitFormat::Tar;
}

std::string symmetries_text(const std::vector<std::string>& found) {
  std::string text = "symmetries found, as of surfaces of revolution:";
  for (const std::string& name : found) text += (&name == &found.front() ? " " : ", ") + name;
  return text;
}

int make(const PictureArguments& given, const CommonOptions& common) {
  PictureArguments arguments = given;
  come_again_when_stopped();
  const UnitFormat form = form_of(arguments);
  PreparedViews views;
  if (!arguments.views.empty())
    views = prepare_views(
        read_input_text(arguments.views, common.limits().max_file_bytes, TextKind::Json),
        arguments.views);
  BatchRun run = pictures_of(arguments.scenes, views.json);
  run.version = TRIVET_VERSION;
  run.format = form;
  if (arguments.per_unit > 0) run.per_unit = arguments.per_unit;
  if (is_data_set(form)) run.per_unit = 1;
  run.with_opengl = arguments.renderer == "opengl";
  const std::string device =
      run.with_opengl ? tried_opengl(common) : "";  // before anything is written
  BatchOptions options = arguments.options;
  const StopSignals from_here;  // as of scenes
  check_run(options.out, run);
  options.shard = arguments.shard.empty() ? shard_from_environment(process_environment())
                                          : shard_from_text(arguments.shard);
  options.jobs = num_jobs(options.jobs, common);
  const Work work = picture_work(run, arguments.scenes, common.limits(), options.out,
                                 opengl_pictures(common, first_worker_of(options)));
  report_to_terminal(options, common);
  if (run.with_opengl) options.log("pictures by " + device);
  options.on_models_read = [&] {
    for (const BatchModel& image : views.images) store_model(image, options.out);
    claim_run(options.out, run);
    const std::vector<std::string> found = begin_data_set(options.out, run, work);
    if (!found.empty()) options.log(symmetries_text(found));
  };
  options.is_ready = [&](std::uint64_t unit) {
    return scenes_are_there(run, arguments.scenes, work.pictures->scenes, unit);
  };
  const BatchTotals totals = run_batch(run, work, options);
  end_data_set(options.out, run, work);
  return print_totals(totals, options, common);
}

}  // namespace

MakePictures opengl_pictures(const CommonOptions& common, std::uint64_t first_worker) {
  return [choice = common.detection(), first_worker](std::uint64_t worker) -> DrawPicture {
    const int device = device_of_worker(choice, first_worker + worker);
    return [pictures = std::shared_ptr(make_gl_pictures(device))](
               const PictureScene& scene, const PinholeCamera& camera, int samples) {
      PictureOptions options;
      options.samples = samples;
      return encode_png(pictures->render(scene, camera, options));
    };
  };
}

std::string tried_opengl(const CommonOptions& common) {
  const int device = common.detection().device;
  return in_child("OpenGL's driver", [=] { return make_gl_pictures(device)->device(); });
}

Verb add_batch_pictures(CLI::App& batch, const CommonOptions& common) {
  CLI::App* const verb =
      batch
          .add_subcommand("pictures",
                          "Make pictures and labels of a batch's scenes, from their poses")
          ->fallthrough();
  const auto a = std::make_shared<PictureArguments>();
  verb->add_option("folder", a->scenes, "The batch of the scenes: --out of trivet batch")
      ->required()
      ->type_name("DIR");
  verb->add_option("--out", a->options.out, "Folder of the pictures; pictures that are there stay")
      ->type_name("DIR");
  verb->add_option(
          "--bop", a->bop,
          "Write a BOP data set to this folder instead: train_pbr/ with a folder for each scene, "
          "models/, camera.json")
      ->type_name("DIR");
  verb->add_option(
          "--coco", a->coco,
          "Write a COCO data set to this folder instead: images/, and annotations.json once "
          "all scenes are there")
      ->type_name("DIR");
  verb->add_option("--views", a->views,
                   "Cameras and images, {\"views\": ...}; default: those of the recipe")
      ->type_name("FILE.json");
  verb->add_option("--shard", a->shard, "Make every N-th unit from I; default: as for trivet batch")
      ->type_name("I/N");
  verb->add_option("--format", a->format, "Form of units: tar or dir")
      ->check(one_of({"tar", "dir"}));
  verb->add_option("--renderer", a->renderer,
                   "Renderer of the pictures: path, rays on the processor, or opengl, on --device; "
                   "labels are always by rays")
      ->check(one_of({"path", "opengl"}));
  verb->add_option("--per-tar", a->per_unit, "Scenes per unit; default: as the scenes")
      ->check(integer_from(1, 1'000'000));
  a->options.limits.scene_seconds = 600;
  add_worker_options(*verb, a->options.jobs, a->options.limits);
  return {verb, [a, &common] { return make(*a, common); }, "", true,
          [a] {
            return VerbFiles{{}, {}, {}, {a->options.out, a->bop, a->coco}};
          }};
}

}  // namespace trivet::apps
