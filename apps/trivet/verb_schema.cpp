#include <iostream>

#include "apps/trivet/verbs.h"

namespace trivet::apps {

Verb add_schema(CLI::App& app, const CommonOptions&) {
  CLI::App* const verb = app.add_subcommand("schema", "Print the JSON Schema of layout files");
  return {verb, [] {
            std::cout << kLayoutSchema;
            return 0;
          }};
}

}  // namespace trivet::apps
