// Layout of the texts of --help: what is the verb's own comes first, examples come last.
#pragma once

#include <CLI/CLI.hpp>

namespace trivet::apps {

inline const char* const kCommonGroup = "Options of all verbs";

/// Formatter of an application and, by inheritance, of the verbs that are added after it is set.
/// Shows the defaults of options that capture them (CLI::App::option_defaults()).
std::shared_ptr<CLI::FormatterBase> help_formatter();

}  // namespace trivet::apps
