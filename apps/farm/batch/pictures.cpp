#include "apps/farm/batch/pictures.h"

#include "core/base/bad_input.h"

namespace trivet::farm {
namespace {

BatchRun scenes_in(const std::string& folder) {
  BatchRun run = read_run(folder);
  if (!run.views.empty())
    bad_input("%1: there are pictures in this folder; accepted: a batch of scenes", folder);
  return run;
}

}  // namespace

BatchRun pictures_of(const std::string& scenes, const std::string& views) {
  BatchRun run = scenes_in(scenes);
  const std::string text = run_json(run);
  run.scenes_sha256 = sha256_hex(text);
  run.with_scene = run.with_contacts = run.with_report = false;
  run.views = views;
  if (views.empty()) run.views = views_text(run.recipe, scenes + "/run.json");
  return run;
}

Work picture_work(const BatchRun& run, const std::string& scenes, const ImportLimits& import,
                  const MakePictures& make_opengl) {
  const BatchRun there = scenes_in(scenes);
  if (sha256_hex(run_json(there)) != run.scenes_sha256)
    bad_input("%1: is not the batch that these pictures are of", scenes);
  Work work = work_of(prepared_recipe(there, scenes), there, import, scenes, true);
  const nlohmann::json views = nlohmann::json::parse(run.views);
  work.pictures = std::make_shared<const PictureWork>(
      PictureWork{scenes, there, read_view_wishes(JsonPlace(views, "views")),
                  run.with_opengl ? make_opengl : nullptr});
  return work;
}

bool scenes_are_there(const BatchRun& run, const PictureWork& work, std::uint64_t unit) {
  const std::uint64_t per_unit = work.scenes.per_unit;
  for (std::uint64_t t = run.first_scene(unit) / per_unit; t * per_unit < run.end_scene(unit); ++t)
    if (!unit_exists(work.folder, t, work.scenes.format)) return false;
  return true;
}

}  // namespace trivet::farm
