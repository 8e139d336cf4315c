#include "apps/farm/batch/pictures.h"

#include <filesystem>
#include <map>

#include "apps/farm/batch/source.h"
#include "apps/farm/pictures/data_set.h"
#include "core/base/bad_input.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnvironments = "environments/";

std::map<std::string, std::string> environment_files(const BatchRun& run, const std::string& scenes,
                                                     const std::string& out) {
  std::map<std::string, std::string> files;
  nlohmann::json views = nlohmann::json::parse(run.views);
  rename_environments(views, [&](const std::string& name) {
    const bool own = name.rfind(kEnvironments, 0) == 0;
    files[name] = (fs::path(own ? out : scenes) / name).string();
    return name;
  });
  return files;
}

}  // namespace

PreparedViews prepare_views(const std::string& text, const std::string& file) {
  PreparedViews out;
  nlohmann::json views = nlohmann::json::parse(views_text(text, file));
  rename_environments(views, [&](const std::string& name) {
    out.environments.push_back(batch_model((fs::path(file).parent_path() / name).string()));
    out.environments.back().stored_in = kEnvironments;
    return out.environments.back().stored_path();
  });
  out.json = views.dump();
  return out;
}

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
                  const std::string& out, const std::function<DrawPicture()>& make_opengl) {
  const BatchRun there = source_of(run, scenes);
  Work work = work_of(prepared_recipe(there, scenes), there, import, scenes, true);
  if (run.format == UnitFormat::Bop) check_rigid(set_labels(work.recipe));
  const nlohmann::json views = nlohmann::json::parse(run.views);
  const Views wishes = read_view_wishes(JsonPlace(views, "views"));
  if (wishes.look && run.with_opengl)
    bad_input("the views have a \"look\", which OpenGL does not draw; accepted: --renderer path");
  const auto environments = std::make_shared<Environments>(environment_files(run, scenes, out));
  work.pictures = std::make_shared<const PictureWork>(PictureWork{
      scenes, there, wishes, run.with_opengl ? make_opengl : nullptr, run.format, environments});
  return work;
}

std::vector<std::string> begin_data_set(const std::string& out, const BatchRun& run,
                                        const Work& work) {
  std::error_code ignored;
  if (run.format != UnitFormat::Bop || fs::exists(fs::path(out) / "models", ignored)) return {};
  return write_bop_models(out, set_labels(work.recipe), load_models(work), work.pictures->views);
}

bool end_data_set(const std::string& out, const BatchRun& run, const Work& work) {
  return run.format != UnitFormat::Coco ||
         write_coco_annotations(out, run, set_labels(work.recipe).classes);
}

}  // namespace trivet::farm
