// Verbs that move one object of a scene: push, turn, pick-up, translate, rotate.
#include "apps/trivet/move_verb.h"
#include "core/base/error.h"

namespace trivet::apps {
namespace {

std::optional<Vec3> vec3(const std::vector<double>& v) {
  if (v.empty()) return std::nullopt;
  return Vec3(v[0], v[1], v[2]);
}

std::optional<Vec2> vec2(const std::vector<double>& v) {
  if (v.empty()) return std::nullopt;
  return Vec2(v[0], v[1]);
}

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

}  // namespace

Verb add_push(CLI::App& app, const CommonOptions& common) {
  MoveVerb<PushArguments> verb(app, "push", "Push an object along its support");
  verb.add_move_options();
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
  verb.add_move_options();
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
  verb.add_move_options();
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
  verb.add_move_options();
  verb.numbers("--by", verb.own->by, 3, "X Y Z", "Metres")->required();
  add_free_flags(verb);
  return verb.done(common, [](const FreeArguments& given) -> Operation {
    return TranslateOperation{{}, *vec3(given.by), given.free, given.settle};
  });
}

Verb add_rotate(CLI::App& app, const CommonOptions& common) {
  MoveVerb<FreeArguments> verb(app, "rotate", "Rotate an object about any axis");
  verb.add_move_options();
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
