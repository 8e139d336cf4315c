#include <cmath>
#include <filesystem>

#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "core/io/process/sandboxed_import.h"
#include "ops/base/names.h"
#include "ops/files/report/geometry.h"
#include "ops/operations/perform.h"

namespace trivet::apps {
namespace {

struct PutArguments {
  std::string scene, model, name, up;
  std::vector<double> position, rotation{1, 0, 0, 0};
  double scale = 1;
  PutOperation operation;  // its tries
  Tessellation tessellation;
  MaterialArguments material;
  OutputPaths outputs;
  SettleArguments settle;
};

Pose start_pose(const PutArguments& arguments) {
  const std::vector<double>&p = arguments.position, &q = arguments.rotation;
  const auto rotation = unit_rotation({q[0], q[1], q[2], q[3]});
  if (!rotation)
    throw Error(Error::Kind::BadInput,
                "--rotation: a quaternion w x y z of length zero is not accepted; accepted: any "
                "other length");
  return {*rotation, {p[0], p[1], p[2]}};
}

// The requested name, or the file's name with the first free number.
std::string free_name(const PutArguments& arguments, const Scene& scene) {
  const std::string wanted = arguments.name.empty()
                                 ? std::filesystem::path(arguments.model).stem().string()
                                 : arguments.name;
  if (!is_object_name(wanted))
    throw Error(
        Error::Kind::BadInput,
        "--name: \"%1\" is not accepted; accepted: UTF-8 without control characters, not \"floor\"",
        wanted);
  if (!arguments.name.empty() && scene.find(wanted))
    throw Error(Error::Kind::BadInput,
                "--name: \"%1\" is taken; accepted: a name not used in the scene", wanted);
  std::string name = wanted;
  for (int i = 2; scene.find(name); ++i) name = wanted + "_" + std::to_string(i);
  return name;
}

// Shares the geometry of objects from the same file.
void share_geometry(const Scene& scene, Object& object) {
  const std::string fingerprint = geometry_fingerprint(object.shape->mesh);
  for (const ObjectId id : scene.ids()) {
    const Object& other = scene.at(id);
    if (other.model->path != object.model->path) continue;
    if (geometry_fingerprint(other.shape->mesh) != fingerprint) continue;
    object.model = other.model;
    object.shape = other.shape;
    return;
  }
}

LayoutObject layout_object(const PutArguments& arguments, const SceneFile& file) {
  LayoutObject object;
  object.name = free_name(arguments, file.scene);
  const std::filesystem::path model(arguments.model);
  object.model =
      model.is_absolute()
          ? arguments.model
          : (std::filesystem::path(folder_from(arguments.scene, folder_of(arguments.model))) /
             model.filename())
                .generic_string();
  object.scale = arguments.scale;
  object.tessellation = arguments.tessellation;
  object.material = arguments.material.material();
  if (!arguments.up.empty()) object.up = arguments.up == "y" ? UpAxis::Y : UpAxis::Z;
  return object;
}

// Loads the object through a layout of its own.
Object load_object(const PutArguments& arguments, const Layout& addition, const Scene& scene,
                   const CommonOptions& common, const RunOptions& options) {
  const ModelSource source = [&](const std::string&, const Tessellation& tessellation) {
    return import_model(arguments.model, common.limits(), tessellation);
  };
  const Scene single = make_scene(addition, source, options);
  Object object = single.at(single.ids().front());
  share_geometry(scene, object);
  return object;
}

int put(const PutArguments& arguments, const CommonOptions& common) {
  const Pose start = start_pose(arguments);
  check_tessellation(arguments.tessellation, arguments.model);
  Outputs outputs(arguments.outputs, {arguments.model}, common);
  SceneFile file = read_scene_file(arguments.scene, common.limits());
  for (const Sentence& note : file.notes) print_note(common, note);
  check_not_inputs(arguments.outputs, model_files(file.layout, folder_of(arguments.scene)));
  Layout addition;
  addition.material = file.layout.material;
  addition.objects.push_back(layout_object(arguments, file));
  PutOperation operation = arguments.operation;
  operation.object = addition.objects.back().name;
  operation.start = start;
  addition.operations.push_back(operation);
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  if (!(options.settle.clearance > 0)) options.settle.clearance = file.clearance;
  options.settle = settle_options(options, file.layout.settle);

  Object object = load_object(arguments, addition, file.scene, common, options);
  LayoutRun run;
  run.scene = std::move(file.scene);
  const ObjectId id = run.scene.add(std::move(object));
  run_operations(addition, options, run);
  if (run.operations.back().result.ok()) {
    file.layout.objects.push_back(addition.objects.back());
    file.layout.operations.push_back(addition.operations.back());
  } else {
    run.scene.remove(id);  // restores the scene
  }
  finish_run(options, run);
  const std::string folder = folder_of(arguments.scene);
  const OutputPaths& paths = arguments.outputs;
  return outputs.write(run, file.layout, options,
                       {folder_from(paths.scene, folder), folder_from(paths.report, folder)});
}

}  // namespace

Verb add_put(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb =
      app.add_subcommand("put", "Put another object into a scene written by trivet");
  const auto arguments = std::make_shared<PutArguments>();
  verb->add_option("scene", arguments->scene, "The scene")->required()->type_name("SCENE.glb");
  verb->add_option("model", arguments->model, "The model file")->required()->type_name("MODEL");
  verb->add_option("--position", arguments->position,
                   "Position of the model's origin from which it falls, metres")
      ->required()
      ->expected(3)
      ->type_name("X Y Z")
      ->check(number_from(-kMaxLength, kMaxLength));
  verb->add_option("--rotation", arguments->rotation, "Rotation at the start, quaternion")
      ->expected(4)
      ->type_name("W X Y Z")
      ->check(number_from(-kMaxQuaternionComponent, kMaxQuaternionComponent));
  verb->add_option("--tries", arguments->operation.tries,
                   "Number of starts to try: where it would topple or be wedged, nearby ones, too")
      ->check(integer_from(1, kMaxTriesOfPut));
  verb->add_option("--within", arguments->operation.within,
                   "Largest distance of these from the position, in parts of the object's size")
      ->check(number_from(0, kMaxWithin));
  verb->add_option("--name", arguments->name, "Name of the object; default: the file's name");
  verb->add_option("--scale", arguments->scale, "Metres per unit of the file")
      ->check(number_from(kMinScale, kMaxScale));
  verb->add_option("--up", arguments->up,
                   "Up axis of the file; default: as its format states, else z")
      ->check(one_of({"y", "z"}));
  add_tessellation_options(*verb, arguments->tessellation);
  add_material_options(*verb, arguments->material);
  add_output_options(*verb, arguments->outputs);
  verb->get_option("--output")->required();
  add_settle_options(*verb, arguments->settle);
  return {verb, [arguments, &common] { return put(*arguments, common); }};
}

}  // namespace trivet::apps
