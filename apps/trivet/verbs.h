// Verbs of the command line, each in its own file verb_<name>.cpp.
#pragma once

#include <functional>

#include "apps/trivet/common.h"
#include "apps/trivet/verb_files.h"

namespace trivet::apps {

/// A verb and its action after parsing. `run` returns 0, or 1 if an operation was refused or a
/// check failed; it throws Error.
struct Verb {
  CLI::App* app;
  std::function<int()> run;
  /// Command lines that show its use, one per line; tests/apps/test_help.py runs them.
  std::string examples = {};
  /// True if the verb has the options of reading models.
  bool reads_models = true;
  /// Files that the program checks before `run`; empty: the verb has none.
  std::function<VerbFiles()> files = {};
};

/// The verbs in the order of --help; `operations` are push, turn, fix and others. A new verb is a
/// word here and its file, which defines add_<name>.
// clang-format off
#define TRIVET_VERBS(VERB) \
  VERB(info) \
  VERB(run) \
  VERB(put) \
  VERB(operations) \
  VERB(check) \
  VERB(settle) \
  VERB(mend) \
  VERB(joint) \
  VERB(intent) \
  VERB(export) \
  VERB(render) \
  VERB(zlist) \
  VERB(arrange) \
  VERB(demo) \
  VERB(session) \
  VERB(mcp) \
  VERB(serve) \
  VERB(replay) \
  VERB(backends) \
  VERB(batch) \
  VERB(doctor) \
  VERB(report) \
  VERB(schema)
// clang-format on

#define TRIVET_DECLARE_VERB(name) \
  std::vector<Verb> add_##name(CLI::App& app, const CommonOptions& common);
TRIVET_VERBS(TRIVET_DECLARE_VERB)
#undef TRIVET_DECLARE_VERB

extern const char* const kLayoutSchema;   // layout.schema.in.json of ops/files/layout
extern const char* const kRecipeSchema;   // text of apps/farm/recipe/recipe.schema.json
extern const char* const kArrangeSchema;  // arrange.schema.in.json of ops/files/arrange
extern const char* const kViewerPage;     // text of apps/python/trivet/viewer.html

}  // namespace trivet::apps
