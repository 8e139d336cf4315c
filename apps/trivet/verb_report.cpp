#include <sys/utsname.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>

#include "apps/farm/node/node_checks.h"
#include "apps/farm/recipe/sha256.h"
#include "apps/farm/store/tar.h"
#include "apps/trivet/case_files.h"
#include "apps/trivet/case_run.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"
#include "core/base/count_of.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "ops/files/json/text.h"

namespace trivet::apps {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ReportArguments {
  std::vector<std::string> command;
  std::string output;
  double seconds = 600;
  bool without_files = false;
};

// Files of the command line that are there before it runs: what it writes is no input.
std::vector<std::string> inputs_of(const std::vector<std::string>& command) {
  std::vector<std::string> out;
  std::error_code ignored;
  for (size_t i = 0; i < command.size(); ++i) {
    const bool written = i > 0 && (command[i - 1] == "-o" || command[i - 1] == "--output");
    if (!written && fs::is_regular_file(command[i], ignored)) out.push_back(command[i]);
  }
  return out;
}

// The innermost folder that holds all of them and the current one.
fs::path common_folder(const std::vector<std::string>& files) {
  fs::path folder = fs::canonical(fs::current_path());
  const auto holds = [&](const std::string& file) {
    const fs::path relative = fs::path(file).lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
  };
  while (folder.has_relative_path() && !std::all_of(files.begin(), files.end(), holds))
    folder = folder.parent_path();
  return folder;
}

std::string name_in(const fs::path& folder, const std::string& file) {
  return "files/" + fs::path(file).lexically_relative(folder).generic_string();
}

// Without the machine's name.
std::string system_name() {
  utsname names{};
  if (uname(&names) != 0) return "";
  return std::string(names.sysname) + " " + names.release + " " + names.machine;
}

Json checks_json() {
  Json out = Json::array();
  for (const farm::NodeCheck& check : farm::check_node({}))
    out.push_back(
        {{"check", check.name}, {"verdict", to_string(check.verdict)}, {"text", check.text}});
  return out;
}

// Arguments that are files, as they are called from the folder of the case.
Json command_json(const std::vector<std::string>& command) {
  Json out = Json::array();
  std::error_code ignored;
  for (const std::string& argument : command) {
    const bool file = fs::path(argument).is_absolute() && fs::is_regular_file(argument, ignored);
    out.push_back(file ? fs::canonical(argument).lexically_relative(fs::current_path()).string()
                       : argument);
  }
  return out;
}

std::string outcome(const CaseRun& run) {
  if (run.out_of_time) return "stopped: out of time";
  if (run.signal != 0) return std::string("crashed: ") + strsignal(run.signal);
  return "exit status " + std::to_string(run.status);
}

struct Case {
  std::string json;
  std::vector<std::string> files;
  fs::path folder;
  CaseRun run;
};

Case make_case(const ReportArguments& arguments, const CommonOptions& common) {
  Case out;
  out.files = files_of_case(inputs_of(arguments.command), common.limits());
  check_not_the_same({arguments.output}, out.files);
  out.folder = common_folder(out.files);
  Json files = Json::array();
  for (const std::string& file : out.files) {
    const std::string bytes = read_text_file(file, common.limits().max_file_bytes);
    files.push_back({{"name", name_in(out.folder, file)},
                     {"bytes", bytes.size()},
                     {"sha256", farm::sha256_hex(bytes)}});
  }
  out.run = run_case(arguments.command, arguments.seconds);
  const std::string folder = fs::current_path().lexically_relative(out.folder).generic_string();
  out.json = readable_json({{"trivet_case", 1},
                            {"version", TRIVET_VERSION},
                            {"system", system_name()},
                            {"command", command_json(arguments.command)},
                            {"folder", folder == "." ? "files" : "files/" + folder},
                            {"outcome", outcome(out.run)},
                            {"files", files},
                            {"files_are_inside", !arguments.without_files},
                            {"checks", checks_json()}});
  return out;
}

void write_case(const Case& found, const ReportArguments& arguments, const CommonOptions& common) {
  write_file_atomically(arguments.output, [&](const ByteSink& sink) {
    farm::TarWriter tar([&](std::string_view bytes) { sink(std::string(bytes)); });
    tar.add("case.json", found.json);
    tar.add("output.txt", found.run.output);
    tar.add("error.txt", found.run.error);
    if (!arguments.without_files)
      for (const std::string& file : found.files)
        tar.add(name_in(found.folder, file), read_text_file(file, common.limits().max_file_bytes));
    tar.finish();
  });
}

int report(const ReportArguments& arguments, const CommonOptions& common) {
  check_extension(arguments.output, {".tar"});
  const Case found = make_case(arguments, common);
  write_case(found, arguments, common);
  if (common.json)
    std::cout << found.json;
  else if (!common.quiet)
    std::cout << arguments.output << ": " << outcome(found.run) << "; "
              << count_of(found.files.size(), "file") << "\n";
  return 0;
}

}  // namespace

std::vector<Verb> add_report(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "report",
      "Run a command once more and pack a case for a bug report: its files, what it printed, how "
      "it ended, the version and the system. Look into the file before you send it");
  const auto arguments = std::make_shared<ReportArguments>();
  verb->add_option("command", arguments->command, "The command after --, without \"trivet\"")
      ->required()
      ->type_name("-- COMMAND ...");
  verb->add_option("-o,--output", arguments->output, "The case")->required()->type_name("CASE.tar");
  verb->add_option("--seconds", arguments->seconds, "Stop the command after this time")
      ->check(number_from(0.1, 1e6))
      ->capture_default_str();
  verb->add_flag("--without-files", arguments->without_files,
                 "List the files with their SHA-256 only");
  return {{verb, [arguments, &common] { return report(*arguments, common); },
           "trivet report -o case.tar -- run layout.json -o scene.glb\n"
           "trivet report -o case.tar --without-files -- check scene.glb\n",
           true,
           [arguments] {
             return VerbFiles{{}, {arguments->output}, inputs_of(arguments->command)};
           }}};
}

}  // namespace trivet::apps
