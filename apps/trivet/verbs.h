// Verbs of the command line, each in its own file verb_<name>.cpp.
#pragma once

#include <functional>

#include "apps/trivet/common.h"

namespace trivet::apps {

/// A verb and its action after parsing. `run` returns 0, or 1 if an operation was refused or a
/// check failed; it throws Error.
struct Verb {
  CLI::App* app;
  std::function<int()> run;
};

Verb add_info(CLI::App& app, const CommonOptions& common);
Verb add_arrange(CLI::App& app, const CommonOptions& common);
Verb add_run(CLI::App& app, const CommonOptions& common);
Verb add_put(CLI::App& app, const CommonOptions& common);
/// push, turn, fix, ...
std::vector<Verb> add_operations(CLI::App& app, const CommonOptions& common);
Verb add_check(CLI::App& app, const CommonOptions& common);
Verb add_export(CLI::App& app, const CommonOptions& common);
Verb add_render(CLI::App& app, const CommonOptions& common);
Verb add_demo(CLI::App& app, const CommonOptions& common);
Verb add_session(CLI::App& app, const CommonOptions& common);
Verb add_serve(CLI::App& app, const CommonOptions& common);
Verb add_replay(CLI::App& app, const CommonOptions& common);
Verb add_zlist(CLI::App& app, const CommonOptions& common);
Verb add_backends(CLI::App& app, const CommonOptions& common);
Verb add_doctor(CLI::App& app, const CommonOptions& common);
Verb add_batch(CLI::App& app, const CommonOptions& common);
Verb add_report(CLI::App& app, const CommonOptions& common);
Verb add_schema(CLI::App& app, const CommonOptions& common);

extern const char* const kLayoutSchema;   // layout.schema.in.json of ops/files/layout
extern const char* const kRecipeSchema;   // text of apps/farm/recipe/recipe.schema.json
extern const char* const kArrangeSchema;  // text of ops/files/arrange/arrange.schema.json

}  // namespace trivet::apps
