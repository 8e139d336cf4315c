#include <iostream>

#include "apps/trivet/motion_lists.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/scene_input.h"
#include "apps/trivet/verbs.h"
#include "apps/trivet/zlist_picture.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/picture/png.h"
#include "ops/base/stopwatch.h"
#include "ops/check/check.h"
#include "ops/placement/clearance.h"

namespace trivet::apps {
namespace {

constexpr int kResolution = 256, kMotionResolution = 64, kLargestMotionResolution = 1024;
constexpr const char* kOfDirections[] = {"--direction", "--region", "--pixel", "--show",
                                         "--max-memory-mb"};

struct ZListArguments {
  std::string input, picture, dump, show = "length";
  std::vector<double> direction{0, 0, -1}, region;
  std::vector<int> pixel;
  int resolution = 0;  // 0: kResolution, or kMotionResolution
  double max_memory_mb = 1024;
  MotionRequest motion;
  SettleArguments settle;
  std::string gpu_lists = "auto", confirm = "auto";  // see DetectionChoice
};

DetectionChoice choice_of(const ZListArguments& arguments, const CommonOptions& common) {
  DetectionChoice choice = common.detection();
  choice.gpu_lists = arguments.gpu_lists;
  choice.confirm = arguments.confirm;
  return choice;
}

// A layout is run first, like by `run`.
Scene scene_of(const ZListArguments& arguments, const CommonOptions& common, int& status) {
  if (lower_extension(arguments.input) != ".json") {
    SceneFile file = read_scene_with_layout(arguments.input, common);
    check_not_inputs({arguments.dump, arguments.picture},
                     model_files(file.layout, folder_of(arguments.input)));
    return std::move(file.scene);
  }
  const Layout layout = read_layout(arguments.input, common.limits().max_file_bytes);
  check_not_inputs({arguments.dump, arguments.picture},
                   model_files(layout, folder_of(arguments.input)));
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  options.layout_file = arguments.input;
  LayoutRun run =
      run_layout(layout, models_in_folder(folder_of(arguments.input), common.limits()), options);
  for (const OperationRecord& record : run.operations) {
    if (record.result.ok()) continue;
    print_note(common,
               record.op + " \"" + record.object + "\": refused: " + record.result.reason());
    status = 1;
  }
  return std::move(run.scene);
}

ProjectionOptions projection_of(const ZListArguments& arguments, const CommonOptions& common) {
  ProjectionOptions out;
  out.direction = Vec3(arguments.direction[0], arguments.direction[1], arguments.direction[2]);
  out.resolution = arguments.resolution ? arguments.resolution : kResolution;
  out.num_threads = common.num_threads;
  out.most_bytes = static_cast<std::size_t>(arguments.max_memory_mb * 1e6);
  if (const std::vector<double>& r = arguments.region; !r.empty())
    out.region = {Vec2(r[0], r[1]), Vec2(r[2], r[3])};
  return out;
}

std::optional<ImagePixel> pixel_of(const ZListArguments& arguments, const Projection& view) {
  if (arguments.pixel.empty()) return std::nullopt;
  const int column = arguments.pixel[0], row = arguments.pixel[1];
  if (column < view.width && row < view.height) return ImagePixel{column, row};
  throw Error(Error::Kind::BadInput,
              "--pixel: %1 %2 is not accepted; accepted: less than %3 %4, the size of the image",
              column, row, view.width, view.height);
}

ZListShow show_of(const std::string& name) {
  if (name == "depth") return ZListShow::Depth;
  return name == "objects" ? ZListShow::Objects : ZListShow::Length;
}

// Prints the meaning of the numbers in the picture.
void print_names(const ZListsOf& what) {
  std::cout << "  objects:";
  for (size_t i = 0; i < what.names.size(); ++i) std::cout << " " << i << " " << what.names[i];
  std::cout << "\n";
}

int resolution_of_motion(const ZListArguments& arguments) {
  const int asked = arguments.resolution ? arguments.resolution : kMotionResolution;
  if (asked <= kLargestMotionResolution) return asked;
  throw Error(Error::Kind::BadInput,
              "--resolution: %1 is not accepted; accepted: 1 to %2 for a motion", asked,
              kLargestMotionResolution);
}

// @param scene  gets its contacts, which say what is carried along.
void zlist_of_motion(Scene& scene, const ZListArguments& arguments, const CommonOptions& common) {
  const int resolution = resolution_of_motion(arguments);
  const double clearance = clearance_of(scene, arguments.settle.settle);
  update_contacts(scene, clearance);
  MotionLists what = motion_of(scene, arguments.motion);
  const BackendOptions options = backend_options(choice_of(arguments, common), print_notes(common));
  const std::unique_ptr<CandidateFinder> finder = make_zlist_stage(options);
  what.finder = finder->name();
  const Stopwatch stopwatch;
  what.lists = motion_zlists(what.query(scene.floor, clearance), *finder, resolution,
                             options.confirmation.enabled ? kConfirmAll : options.confirmation);
  what.milliseconds = stopwatch.milliseconds();
  clear_progress_line(common);
  if (!arguments.picture.empty())
    write_file_atomically(arguments.picture, encode_png(motion_picture(what)));
  if (!arguments.dump.empty())
    write_file_atomically(arguments.dump,
                          [&](const ByteSink& write) { write_motion(what, write); });
  if (common.json)
    std::cout << motion_json(what);
  else if (!common.quiet)
    std::cout << motion_text(what);
}

void zlist_of_direction(const Scene& scene, const ZListArguments& arguments,
                        const CommonOptions& common) {
  ZListsOf what;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    what.names.push_back(object.name);
    what.bodies.emplace_back(*object.shape, object.world_from_object());
  }
  const Stopwatch stopwatch;
  const CompleteZLists lists(what.bodies, projection_of(arguments, common));
  what.milliseconds = stopwatch.milliseconds();
  what.lists = &lists;
  const std::optional<ImagePixel> pixel = pixel_of(arguments, lists.projection());
  clear_progress_line(common);
  if (!arguments.picture.empty())
    write_file_atomically(arguments.picture,
                          encode_png(zlists_picture(what, show_of(arguments.show))));
  if (!arguments.dump.empty())
    write_file_atomically(arguments.dump,
                          [&](const ByteSink& write) { write_zlists(what, write); });
  if (common.json)
    std::cout << zlists_json(what, pixel);
  else if (!common.quiet || pixel)
    std::cout << zlists_text(what, pixel);
  if (!common.json && !common.quiet && show_of(arguments.show) == ZListShow::Objects)
    print_names(what);
}

int zlist(const ZListArguments& arguments, const CommonOptions& common) {
  if (arguments.motion.raise > 0 && !arguments.motion.is_set())
    throw Error(Error::Kind::BadInput,
                "--raise: nothing is lifted; accepted: with --drop, --move or --turn");
  int status = 0;
  Scene scene = scene_of(arguments, common, status);
  if (arguments.motion.is_set())
    zlist_of_motion(scene, arguments, common);
  else
    zlist_of_direction(scene, arguments, common);
  return status;
}

void add_motion_options(CLI::App& verb, MotionRequest& motion) {
  const char* const group = "Motion, instead of a direction";
  CLI::Option* const drop =
      verb.add_option("--drop", motion.drop, "Z-lists of this object's fall, with its loads")
          ->group(group);
  CLI::Option* const move =
      verb.add_option("--move", motion.move, "Z-lists of this object's motion by --along")
          ->group(group);
  CLI::Option* const turn =
      verb.add_option("--turn", motion.turn,
                      "Z-lists of this object's turn about --axis by --angle-deg")
          ->group(group);
  drop->excludes(move)->excludes(turn);
  move->excludes(turn);
  for (CLI::Option* const option : {drop, move, turn}) {
    option->type_name("NAME");
    for (const char* const other : kOfDirections) option->excludes(verb.get_option(other));
  }
  const auto number = number_from(-kMaxLength, kMaxLength);
  verb.add_option("--along", motion.along, "Displacement (metres)")
      ->expected(3)
      ->type_name("X Y Z")
      ->check(number)
      ->needs(move)
      ->group(group);
  verb.add_option("--axis", motion.axis, "Axis of the turn; default: up")
      ->expected(3)
      ->type_name("X Y Z")
      ->check(number)
      ->needs(turn)
      ->group(group);
  verb.add_option("--centre", motion.centre,
                  "A point on the axis; default: the centre of mass (metres)")
      ->expected(3)
      ->type_name("X Y Z")
      ->check(number)
      ->needs(turn)
      ->group(group);
  verb.add_option("--angle-deg", motion.angle_deg,
                  "Angle, right-handed about the axis (degrees); default: 90")
      ->check(number_from(-90, 90))
      ->needs(turn)
      ->group(group);
  verb.add_option("--raise", motion.raise, "Height to lift the object by first (metres)")
      ->check(number_from(0, kMaxLength))
      ->group(group);
}

// Stages of the answer, which no result depends on.
void add_stage_options(CLI::App& verb, ZListArguments& arguments) {
  const char* const group = "Stages of a motion";
  verb.add_option("--gpu-lists", arguments.gpu_lists,
                  "Stage that lists the faces of a GPU's doubtful pixels; auto: the cheaper one")
      ->check(one_of({"auto", "gpu", "software"}))
      ->group(group);
  verb.add_option("--confirm", arguments.confirm,
                  "Visits of the listed faces by Embree; auto: where they are many")
      ->check(one_of({"auto", "embree", "off"}))
      ->group(group);
}

}  // namespace

std::vector<Verb> add_zlist(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "zlist",
      "Print the z-lists of a scene along a direction: all faces in every pixel, sorted by depth, "
      "without the floor; or those of a motion: fronts of what moves and of what is in the way");
  const auto arguments = std::make_shared<ZListArguments>();
  verb->add_option("input", arguments->input,
                   "A scene written by trivet, a layout (run first), or any model")
      ->required()
      ->type_name("SCENE.glb|LAYOUT.json|MODEL");
  verb->add_option("--direction", arguments->direction, "Viewing direction; default: down")
      ->expected(3)
      ->type_name("X Y Z")
      ->check(number_from(-kMaxLength, kMaxLength));
  verb->add_option("--resolution", arguments->resolution,
                   "Pixels along the longer side; default: 256, of a motion 64")
      ->check(integer_from(1, 8192));
  verb->add_option("--region", arguments->region,
                   "Zoom in: two corners, metres to the right and up; default: everything")
      ->expected(4)
      ->type_name("LEFT BOTTOM RIGHT TOP")
      ->check(number_from(-kMaxLength, kMaxLength));
  verb->add_option("--pixel", arguments->pixel, "Print the list of this pixel, counted from above")
      ->expected(2)
      ->type_name("COLUMN ROW")
      ->check(integer_from(0, 8191));
  verb->add_option("-o,--output", arguments->picture, "Write a picture of all lists, .png");
  verb->add_option("--show", arguments->show, "Content of the picture: length, depth or objects")
      ->check(one_of({"length", "depth", "objects"}));
  verb->add_option("--dump", arguments->dump, "Write all lists, as JSON lines");
  verb->add_option("--max-memory-mb", arguments->max_memory_mb, "Refuse longer lists")
      ->check(number_from(1, 1e6));
  add_motion_options(*verb, arguments->motion);
  add_stage_options(*verb, *arguments);
  add_settle_options(*verb, arguments->settle);
  return {{verb, [arguments, &common] { return zlist(*arguments, common); },
           "trivet zlist scene.glb -o lists.png\n"
           "trivet zlist scene.glb --pixel 128 128 --json\n",
           true,
           [arguments] {
             return VerbFiles{{{"", arguments->dump, arguments->picture}}, {}, {arguments->input}};
           }}};
}

}  // namespace trivet::apps
