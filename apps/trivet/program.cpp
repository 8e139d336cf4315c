#include "apps/trivet/program.h"

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstring>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/trivet/help.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/io/process/sandboxed_import.h"

namespace trivet::apps {
namespace {

constexpr int kBadInput = 2, kEnvironment = 3;

int fail(bool json, const char* kind, const std::string& message, int status) {
  if (json) {
    const nlohmann::ordered_json error = {
        {"error", {{"kind", kind}, {"message", message}, {"status", status}}}};
    std::cout << error.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  } else {
    std::cerr << "trivet: " << message << "\n";
  }
  std::cout.flush();
  return status;
}

// Runs before the command line is parsed, and also if parsing fails.
bool asks_for_json(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (std::strcmp(argv[i], "--json") == 0) return true;
  return false;
}

// The end of a verb's --help.
std::string footer_of(const Verb& verb) {
  std::istringstream lines(verb.examples);
  std::string out = "Examples:\n";
  for (std::string line; std::getline(lines, line);) out += "  " + line + "\n";
  return out;
}

std::vector<Verb> add_verbs(CLI::App& app, CommonOptions& common) {
  std::vector<Verb> verbs;
#define TRIVET_ADD_VERB(name) \
  for (Verb & verb : add_##name(app, common)) verbs.push_back(std::move(verb));
  TRIVET_VERBS(TRIVET_ADD_VERB)
#undef TRIVET_ADD_VERB
  for (const Verb& verb : verbs) {
    add_common_options(*verb.app, common);
    if (verb.reads_models) add_import_options(*verb.app, common);
    verb.app->footer(footer_of(verb));
  }
  return verbs;
}

// Hint shown for a missing or unknown verb.
std::string accepted_verbs(const CLI::App& app, const std::string& given = "") {
  if (!app.get_subcommands().empty()) return "";
  std::string list;
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(verb->get_name());
    list += (list.empty() ? "; accepted verbs: " : ", ") + names.back();
  }
  return list + in_english(did_you_mean(given, names));
}

// The verb that was given, else the program.
const CLI::App& parsed_part(const CLI::App& app) {
  const auto verbs = app.get_subcommands();
  return verbs.empty() ? app : *verbs.front();
}

// Names the first option that is none; empty: all are known.
std::string unknown_option(const CLI::App& app, int argc, char** argv) {
  const CLI::App& part = parsed_part(app);
  std::vector<std::string> names;
  for (const CLI::Option* option : part.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  for (int i = 1; i < argc; ++i) {
    const std::string given = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (given.size() < 3 || given.compare(0, 2, "--") != 0) continue;
    if (std::find(names.begin(), names.end(), given) == names.end())
      return part.get_name() + ": there is no option " + given +
             in_english(did_you_mean(given, names));
  }
  return "";
}

std::string message_of(const CLI::ParseError& error, const CLI::App& app, int argc, char** argv) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error))
    if (const std::string unknown = unknown_option(app, argc, argv); !unknown.empty())
      return unknown + accepted_verbs(app);
  return error.what() + accepted_verbs(app, argc > 1 ? argv[1] : "");
}

// Where the system cannot confine what reads models, once.
void warn_of_importers(const CommonOptions& common) {
  const auto protection = import_protection();
  if (protection && !protection->whole()) print_note(common, warning_about(*protection));
}

int do_verb(const std::vector<Verb>& verbs, const CommonOptions& common) {
  const auto all = tbb::global_control::max_allowed_parallelism;
  const tbb::global_control threads(all, common.num_threads > 0
                                             ? static_cast<size_t>(common.num_threads)
                                             : tbb::global_control::active_value(all));
  for (const Verb& verb : verbs)
    if (verb.app->parsed()) {
      // Workers of batches are forked: what EGL opens must not be here.
      if (verb.app->get_name() != "batch") check_detection(common.detection());
      if (verb.files) check_files(verb.files());
      const int status = verb.run();
      warn_of_importers(common);
      if (!std::cout.flush())
        throw Error(Error::Kind::Environment, "cannot write to the standard output");
      return status;
    }
  return kBadInput;
}

// The parser would take -.1 for an option.
std::vector<std::string> arguments_of(int argc, char** argv) {
  std::vector<std::string> out;
  for (int i = 1; i < argc; ++i) {
    const std::string given = argv[i];
    const bool negative = given.size() > 2 && given[0] == '-' && given[1] == '.' &&
                          '0' <= given[2] && given[2] <= '9';
    out.push_back(negative ? "-0" + given.substr(1) : given);
  }
  std::reverse(out.begin(), out.end());  // as the parser wants them
  return out;
}

}  // namespace

int run_program(int argc, char** argv) {
  const bool json = asks_for_json(argc, argv);
  CLI::App app(
      "Lays out 3D objects without interpenetration, at rest.\n"
      "Exit status: 0 done; 1 an operation was refused or a check failed; 2 wrong usage or "
      "bad input; 3 the environment.",
      "trivet");
  app.formatter(help_formatter());
  app.option_defaults()->always_capture_default();
  CommonOptions common;
  const std::vector<Verb> verbs = add_verbs(app, common);
  add_common_options(app, common);
  add_import_options(app, common);
  app.require_subcommand(0, 1);  // a missing verb is reported with the accepted ones
  try {
    app.parse(arguments_of(argc, argv));
    if (app.get_subcommands().empty())
      return fail(json, "usage", "a verb is missing" + accepted_verbs(app), kBadInput);
    return do_verb(verbs, common);
  } catch (const CLI::Success& e) {  // help and version
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    return fail(json, "usage", message_of(e, app, argc, argv) + " (see trivet --help)", kBadInput);
  } catch (const Error& e) {
    const bool bad_input = e.kind() == Error::Kind::BadInput;
    return fail(json, bad_input ? "bad input" : "environment", e.what(),
                bad_input ? kBadInput : kEnvironment);
  } catch (const std::bad_alloc&) {
    return fail(json, "environment", "not enough memory", kEnvironment);
  } catch (const nlohmann::json::exception&) {  // in its own words it says nothing to users
    return fail(json, "bad input",
                "a file is damaged: a value in it is missing, or of another kind", kBadInput);
  } catch (const std::exception& e) {
    return fail(json, "environment", std::string("unexpected: ") + e.what(), kEnvironment);
  }
}

}  // namespace trivet::apps
