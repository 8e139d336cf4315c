// Verbs that move one object of a scene: push, turn, pick-up, translate, rotate; and fix, unfix and
// material.
#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "ops/base/refusal.h"
#include "ops/check/check.h"
#include "ops/files/json/operation_json.h"

namespace trivet::apps {
namespace {

/// Arguments common to all of them, and conversion of the verb's own options to the operation.
struct MoveArguments {
  std::string scene;
  JointMoveOptions move;
  OutputPaths outputs;
  SettleArguments settle;
};

std::optional<Vec3> vec3(const std::vector<double>& v) {
  if (v.empty()) return std::nullopt;
  return Vec3(v[0], v[1], v[2]);
}

std::optional<Vec2> vec2(const std::vector<double>& v) {
  if (v.empty()) return std::nullopt;
  return Vec2(v[0], v[1]);
}

// Reads the operation like one of a layout: with the same limits and the same messages.
Operation checked(const Operation& operation) {
  const nlohmann::json json = operation_json(operation);
  return read_operation(JsonPlace(json, std::string("options of ") + op_name(operation)));
}

int move(const MoveArguments& arguments, const Operation& asked, const CommonOptions& common) {
  const Operation operation = checked(asked);
  Outputs outputs(arguments.outputs, {}, common);
  SceneFile file = read_scene_file(arguments.scene, common.limits());
  for (const std::string& note : file.notes) print_note(common, note);
  check_not_inputs(arguments.outputs, model_files(file.layout, folder_of(arguments.scene)));
  std::vector<std::string> names = arguments.move.together;
  names.insert(names.begin(), arguments.move.object);
  for (const std::string& name : names)
    if (!file.scene.find(name))
      throw Error(Error::Kind::BadInput,
                  arguments.scene + ": " + message(unknown_object(file.scene, name)));
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  if (!(options.settle.clearance > 0)) options.settle.clearance = file.clearance;
  options.settle = settle_options(options, file.layout.settle);
  update_contacts(file.scene, options.settle.clearance, options.settle);
  LayoutRun run;
  run.scene = std::move(file.scene);
  Layout addition;
  addition.operations.push_back(operation);
  run_operations(addition, options, run);
  if (run.operations.back().result.ok()) file.layout.operations.push_back(operation);
  finish_run(options, run);
  const std::string folder = folder_of(arguments.scene);
  const OutputPaths& paths = arguments.outputs;
  return outputs.write(run, file.layout, options,
                       {folder_from(paths.scene, folder), folder_from(paths.report, folder)});
}

/// A verb with the common arguments; the operation is made from `Own` after parsing.
template <class Own>
struct MoveVerb {
  CLI::App* app;
  std::shared_ptr<MoveArguments> arguments = std::make_shared<MoveArguments>();
  std::shared_ptr<Own> own = std::make_shared<Own>();

  MoveVerb(CLI::App& program, const char* name, const char* what)
      : app(program.add_subcommand(name, what)) {
    app->add_option("scene", arguments->scene, "A scene written by trivet")
        ->required()
        ->type_name("SCENE.glb");
    app->add_option("object", arguments->move.object, "Name of the object")
        ->required()
        ->type_name("OBJECT");
    if constexpr (std::is_empty_v<Own> || std::is_same_v<Own, MaterialArguments>) return;
    app->add_flag("--settle-left", arguments->move.settle_left,
                  "Let objects that lose their support settle");
    app->add_option("--together", arguments->move.together,
                    "Another object that moves along; may be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME");
  }

  CLI::Option* numbers(const char* option, std::vector<double>& values, int count, const char* type,
                       const char* what) {
    return app->add_option(option, values, what)
        ->expected(count)
        ->type_name(type)
        ->check(number_from(-kMaxLength, kMaxLength));
  }
  CLI::Option* axis(std::vector<double>& values, const char* what) {
    return app->add_option("--axis", values, what)
        ->expected(3)
        ->type_name("X Y Z")
        ->check(number_from(-kMaxDirectionComponent, kMaxDirectionComponent));
  }
  CLI::Option* angle(double& value) {
    return app->add_option("--angle-deg", value, "Degrees, right-handed")
        ->required()
        ->check(number_from(-kMaxAngleDeg, kMaxAngleDeg));
  }
  CLI::Option* length(const char* option, double& value, const char* what) {
    return app->add_option(option, value, what)->check(number_from(0, kMaxLength));
  }

  Verb done(const CommonOptions& common, std::function<Operation(const Own&)> operation) {
    add_output_options(*app, arguments->outputs);
    app->get_option("--output")->required();
    add_settle_options(*app, arguments->settle);
    return {app, [a = arguments, o = own, operation, &common] {
              Operation wanted = operation(*o);
              std::visit(
                  [&](auto& m) {
                    if constexpr (std::is_base_of_v<JointMoveOptions, std::decay_t<decltype(m)>>)
                      static_cast<JointMoveOptions&>(m) = a->move;
                    else
                      m.object = a->move.object;
                  },
                  wanted);
              return move(*a, wanted, common);
            }};
  }
};

struct PushArguments {
  PushOperation operation;
  std::vector<double> direction, to, normal;
  bool no_slide = false, no_settle = false;
};

struct TurnArguments {
  TurnOperation operation;
  std::string about = "normal", with;
  std::vector<double> point, centre, axis;
};

struct PickUpArguments {
  PickUpOperation operation;
  std::string with;
};

struct FreeArguments {
  std::vector<double> by, axis, centre;
  double angle_deg = 0;
  bool free = false, settle = false;
};

struct NoArguments {};  // for verbs without options of their own

std::optional<std::string> text(const std::string& value) {
  if (value.empty()) return std::nullopt;
  return value;
}

Operation turn_of(const TurnArguments& a) {
  TurnOperation o = a.operation;
  o.about = a.about == "line"    ? TurnOperation::About::Line
            : a.about == "point" ? TurnOperation::About::Point
                                 : TurnOperation::About::Normal;
  o.with = text(a.with);
  o.point = vec3(a.point), o.centre = vec3(a.centre), o.axis = vec3(a.axis);
  const bool normal = o.about == TurnOperation::About::Normal;
  if (normal ? o.point || o.axis : o.centre.has_value())
    throw Error(Error::Kind::BadInput,
                normal ? "--point and --axis are not accepted with --about normal; accepted: "
                         "--centre"
                       : "--centre is not accepted with --about " + a.about +
                             "; accepted: --point, --axis");
  return o;
}

template <class Own>
void add_free_flags(MoveVerb<Own>& verb) {
  verb.app->add_flag("--free", verb.own->free, "Ignore collisions, as in a modeller");
  verb.app->add_flag("--settle", verb.own->settle, "Settle at the end");
}

Verb add_fixing(CLI::App& app, const CommonOptions& common, bool fixed, const char* what) {
  MoveVerb<NoArguments> verb(app, fixed ? "fix" : "unfix", what);
  return verb.done(common, [fixed](const NoArguments&) -> Operation {
    return FixOperation{"", fixed};
  });
}

}  // namespace

Verb add_fix(CLI::App& app, const CommonOptions& common) {
  return add_fixing(app, common, true, "Fix an object: it never moves and supports any load");
}

Verb add_unfix(CLI::App& app, const CommonOptions& common) {
  return add_fixing(app, common, false, "Unfix an object: it can be moved, with its loads");
}

Verb add_material(CLI::App& app, const CommonOptions& common) {
  MoveVerb<MaterialArguments> verb(app, "material", "Say what an object is made of");
  add_material_options(*verb.app, *verb.own);
  return verb.done(common, [](const MaterialArguments& given) -> Operation {
    const auto material = given.material();
    if (!material)
      throw Error(Error::Kind::BadInput,
                  "material needs one; accepted: --material NAME, --friction, --density, "
                  "--restitution");
    return MaterialOperation{"", *material};
  });
}

Verb add_push(CLI::App& app, const CommonOptions& common) {
  MoveVerb<PushArguments> verb(app, "push", "Push an object along its support");
  PushArguments& a = *verb.own;
  CLI::Option* const direction =
      verb.app->add_option("--direction", a.direction, "Direction, seen from above")
          ->expected(2)
          ->type_name("X Y")
          ->check(number_from(-kMaxDirectionComponent, kMaxDirectionComponent));
  CLI::Option* const distance =
      verb.length("--distance", a.operation.distance, "Metres in that direction");
  CLI::Option* const to =
      verb.numbers("--to", a.to, 2, "X Y", "Alternative: target position, seen from above");
  verb.numbers("--normal", a.normal, 3, "X Y Z",
               "Of a wall or ceiling, towards the object: push along it, right and up instead of X "
               "and Y; default: 0 0 1");
  direction->needs(distance)->excludes(to);
  distance->needs(direction)->excludes(to);
  verb.length("--step-up", a.operation.step_up,
              "Metres; higher steps stop the object; default: 0.01");
  verb.length("--step-down", a.operation.step_down,
              "Metres; deeper edges stop the object; default: 0.01");
  verb.app->add_flag("--no-slide", a.no_slide, "Stop at walls instead of sliding along them");
  verb.app->add_flag("--no-settle", a.no_settle,
                     "Hold the object at the end instead of settling it");
  return verb.done(common, [](const PushArguments& given) -> Operation {
    if (given.direction.empty() && given.to.empty())
      throw Error(Error::Kind::BadInput,
                  "push needs a target; accepted: --direction X Y --distance D, or --to "
                  "X Y");
    PushOperation o = given.operation;
    if (!given.to.empty()) o.to = vec2(given.to);
    if (!given.normal.empty()) o.normal = *vec3(given.normal);
    if (!given.direction.empty()) o.direction = *vec2(given.direction);
    o.slide = !given.no_slide, o.settle = !given.no_settle;
    return o;
  });
}

Verb add_turn(CLI::App& app, const CommonOptions& common) {
  MoveVerb<TurnArguments> verb(app, "turn", "Turn an object about a held contact");
  TurnArguments& a = *verb.own;
  verb.angle(a.operation.angle_deg);
  verb.app->add_option("--about", a.about, "normal, line or point of the contact; default: normal")
      ->check(one_of({"normal", "line", "point"}));
  verb.app->add_option("--with", a.with, "Object of the contact; default: the main support");
  verb.numbers("--point", a.point, 3, "X Y Z", "Selects the nearest line or point");
  verb.numbers("--centre", a.centre, 3, "X Y Z", "A point on the axis; default: the contact's");
  verb.axis(a.axis, "Axis through the point, or direction along the line");
  verb.app->add_flag("--settle", a.operation.settle, "Settle at the end");
  return verb.done(common, turn_of);
}

Verb add_pick_up(CLI::App& app, const CommonOptions& common) {
  MoveVerb<PickUpArguments> verb(app, "pick-up", "Lift an object off its support");
  PickUpArguments& a = *verb.own;
  verb.length("--distance", a.operation.distance, "Metres along the contact normal")->required();
  verb.app->add_option("--with", a.with, "Object of the contact; default: all supports");
  return verb.done(common, [](const PickUpArguments& given) -> Operation {
    PickUpOperation o = given.operation;
    o.with = text(given.with);
    return o;
  });
}

Verb add_translate(CLI::App& app, const CommonOptions& common) {
  MoveVerb<FreeArguments> verb(app, "translate", "Translate an object");
  verb.numbers("--by", verb.own->by, 3, "X Y Z", "Metres")->required();
  add_free_flags(verb);
  return verb.done(common, [](const FreeArguments& given) -> Operation {
    return TranslateOperation{{}, *vec3(given.by), given.free, given.settle};
  });
}

Verb add_rotate(CLI::App& app, const CommonOptions& common) {
  MoveVerb<FreeArguments> verb(app, "rotate", "Rotate an object about any axis");
  verb.axis(verb.own->axis, "Axis of rotation")->required();
  verb.angle(verb.own->angle_deg);
  verb.numbers("--centre", verb.own->centre, 3, "X Y Z",
               "A point on the axis; default: the centre of mass");
  add_free_flags(verb);
  return verb.done(common, [](const FreeArguments& given) -> Operation {
    return RotateOperation{{},         *vec3(given.axis), given.angle_deg, vec3(given.centre),
                           given.free, given.settle};
  });
}

}  // namespace trivet::apps
