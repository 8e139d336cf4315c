// Base of the verbs that do one operation to one object of a scene. Private to them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"

namespace trivet::apps {

/// Arguments common to all of them.
struct MoveArguments {
  std::string scene;
  JointMoveOptions move;
  OutputPaths outputs;
  SettleArguments settle;
};

/// Does the operation to the scene, and writes what came of it. @return the exit status.
int run_move(const MoveArguments& arguments, const Operation& asked, const CommonOptions& common);

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
  }

  /// Adds the options of verbs that move it.
  void add_move_options() {
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
              return run_move(*a, wanted, common);
            }};
  }
};

}  // namespace trivet::apps
