// Layout of the texts of --help: what is the verb's own comes first, examples come last.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace trivet::apps {

inline const char* const kCommonGroup = "Options of all verbs";

/// Formatter of an application and, by inheritance, of the verbs that are added after it is set.
/// Shows the defaults of options that capture them (CLI::App::option_defaults()).
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Two command lines or more that show a verb's use, one per line; tests/apps/test_help.py runs
/// them. @param verb  its name. @return "" for a name that is no verb's.
std::string examples_of(const std::string& verb);

}  // namespace trivet::apps
