#include <algorithm>
#include <filesystem>

#include "apps/demo/arranged.h"
#include "apps/demo/demo.h"
#include "apps/trivet/arranging.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/export.h"
#include "core/io/staged_files.h"
#include "ops/files/json/text.h"

namespace trivet::apps {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxDemoBytes = 1 << 30;

struct DemoArguments {
  std::string name, folder;
  OutputPaths outputs;
  SettleArguments settle;
  ArrangingOptions arranging;
};

/// A temporary folder for the demo's files.
class DemoFolder {
 public:
  DemoFolder() : m_path((fs::temp_directory_path() / "trivet_demo_XXXXXX").string()) {
    if (!mkdtemp(m_path.data()))
      throw Error(Error::Kind::Environment, "%1: cannot create a temporary folder", m_path);
  }
  ~DemoFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
  }
  DemoFolder(const DemoFolder&) = delete;
  DemoFolder& operator=(const DemoFolder&) = delete;

  std::string file(const std::string& name) const { return (fs::path(m_path) / name).string(); }
  const std::string& path() const { return m_path; }

 private:
  std::string m_path;
};

void add_copy(const fs::path& from, const fs::path& to, StagedFiles& staged) {
  const std::string bytes = read_text_file(from.string(), kMaxDemoBytes);
  std::error_code ignored;
  if (fs::exists(to, ignored) && read_text_file(to.string(), kMaxDemoBytes) != bytes)
    throw Error(Error::Kind::BadInput,
                "%1: is there already, and is not what this demo has; accepted: another folder for "
                "--export",
                to.string());
  staged.add(to.string(), bytes);
}

// Other files of these names that are there are kept, as scenes may name them.
void export_files(const DemoFolder& made, const std::string& folder) {
  if (folder.empty()) return;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Error(Error::Kind::Environment, "%1: cannot be created: %2", folder,
                error.message().c_str());
  StagedFiles staged;
  for (const fs::directory_entry& entry : fs::directory_iterator(made.path()))
    add_copy(entry.path(), fs::path(folder) / entry.path().filename(), staged);
  staged.commit();
}

void write_models(const std::vector<DemoModel>& models, const DemoFolder& folder) {
  for (const DemoModel& made : models) {
    ExportScene scene;
    scene.objects.push_back({fs::path(made.file).stem().string(),
                             std::make_shared<const Model>(made.model), Affine{}, ""});
    write_scene(scene, folder.file(made.file));
  }
}

// Files that --export leaves for trivet run, trivet arrange and trivet batch.
std::vector<std::string> exported_files(const std::vector<std::string>& layouts,
                                        const std::vector<DemoModel>& models,
                                        const std::string& folder) {
  if (folder.empty()) return {};
  std::vector<std::string> out;
  out.reserve(layouts.size() + models.size());
  for (const std::string& layout : layouts) out.push_back((fs::path(folder) / layout).string());
  for (const DemoModel& made : models) out.push_back((fs::path(folder) / made.file).string());
  return out;
}

PictureRequest picture_from(const DemoView& view) {
  PictureRequest request;
  for (const Vec3& p : {view.eye, view.target})
    request.camera.insert(request.camera.end(), p.begin(), p.end());
  request.fov_deg = view.fov_deg;
  return request;
}

// Runs from files, like a user would: the same bits with and without --export.
int run_demo(const DemoArguments& arguments, const CommonOptions& common) {
  const DemoLayout demo = make_demo(arguments.name);
  check_not_the_same(arguments.outputs.all(),
                     exported_files({"layout.json"}, demo.models, arguments.folder));
  Outputs outputs(arguments.outputs, common, picture_from(demo.view));
  const DemoFolder folder;
  write_models(demo.models, folder);
  write_file_atomically(folder.file("layout.json"), layout_json(demo));
  export_files(folder, arguments.folder);
  const Layout layout = read_layout(folder.file("layout.json"));
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  options.layout_file = folder.file("layout.json");
  const LayoutRun result =
      run_layout(layout, models_in_folder(folder.path(), common.limits()), options);
  const std::string& scene = arguments.outputs.scene;
  const std::string in_scene = arguments.folder.empty() ? "" : folder_from(scene, arguments.folder);
  return outputs.write(result, layout, options, {in_scene, ""});
}

int run_arranged_demo(const DemoArguments& arguments, const CommonOptions& common) {
  const ArrangedDemo demo = make_arranged_demo(arguments.name);
  const auto exported =
      exported_files({"problem.json", "recipe.json"}, demo.models, arguments.folder);
  for (const OutputPaths& paths : outputs_of_solutions(arguments.outputs, arguments.arranging))
    check_not_the_same(paths.all(), exported);
  const DemoFolder folder;
  write_models(demo.models, folder);
  write_file_atomically(folder.file("problem.json"), demo.problem);
  write_file_atomically(folder.file("recipe.json"), demo.recipe);
  export_files(folder, arguments.folder);
  const std::string& scene = arguments.outputs.scene;
  const std::string in_scene = arguments.folder.empty() ? "" : folder_from(scene, arguments.folder);
  return arrange_file(
      {folder.file("problem.json"), arguments.outputs, picture_from(demo.view), {in_scene, ""}},
      arguments.arranging, arguments.settle, common);
}

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out.append(out.empty() ? "" : ", ").append(name);
  return out;
}

bool is_arranged(const std::string& demo) {
  const std::vector<std::string> names = arranged_demo_names();
  return std::find(names.begin(), names.end(), demo) != names.end();
}

std::vector<std::string> all_demo_names() {
  std::vector<std::string> out = demo_names();
  for (const std::string& name : arranged_demo_names()) out.push_back(name);
  return out;
}

int run_any_demo(const DemoArguments& arguments, const CommonOptions& common) {
  if (is_arranged(arguments.name)) return run_arranged_demo(arguments, common);
  if (arguments.arranging.seed || arguments.arranging.seconds > 0 ||
      arguments.arranging.solutions > 1)
    throw Error(Error::Kind::BadInput,
                "--seed, --seconds and --solutions: the demo %1 is laid out by operations; "
                "accepted: with %2",
                arguments.name, listed(arranged_demo_names()));
  return run_demo(arguments, common);
}

}  // namespace

std::vector<Verb> add_demo(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand("demo", "Lay out a built-in scene");
  const auto arguments = std::make_shared<DemoArguments>();
  const std::vector<std::string> names = all_demo_names();
  verb->add_option("name", arguments->name, "One of " + CLI::detail::join(names, ", "))
      ->required()
      ->type_name("NAME")
      ->check(one_of(names).description(""));  // the type's column has no room for them
  add_output_options(*verb, arguments->outputs);
  verb->get_option("--output")->required();
  verb->add_option(
          "--export", arguments->folder,
          "Write layout.json (or problem.json and recipe.json) and the models to this folder, for "
          "trivet run (or trivet arrange and trivet batch)")
      ->type_name("DIR");
  add_arranging_options(*verb, arguments->arranging);
  add_settle_options(*verb, arguments->settle);
  return {{verb, [arguments, &common] { return run_any_demo(*arguments, common); },
           "trivet demo spoon-saucer -o scene.glb\n"
           "trivet demo breakfast -o breakfast.glb --export breakfast\n",
           true,
           [arguments] {
             VerbFiles out{{arguments->outputs}, {}, {}, {arguments->folder}};
             if (is_arranged(arguments->name))
               out.scenes = outputs_of_solutions(arguments->outputs, arguments->arranging);
             return out;
           }}};
}

}  // namespace trivet::apps
