// Verbs that say what an object is: fix, unfix, material.
#include "apps/trivet/move_verb.h"
#include "core/base/error.h"

namespace trivet::apps {
namespace {

struct NoArguments {};  // of verbs without options of their own

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

}  // namespace trivet::apps
