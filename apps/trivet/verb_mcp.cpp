// mcp: scenes laid out by agents, over the Model Context Protocol.
#include <filesystem>

#include "apps/mcp/server.h"
#include "apps/trivet/agents.h"
#include "apps/trivet/cancellable_lines.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"

namespace trivet::apps {
namespace {

struct McpArguments {
  std::string folder = ".";
  ForeignArguments foreign;
  SettleArguments settle;
};

mcp::WorkplaceOptions workplace_options(const McpArguments& arguments, const CommonOptions& common,
                                        Detector& detector) {
  std::error_code error;
  if (!std::filesystem::is_directory(arguments.folder, error))
    throw Error(Error::Kind::BadInput, "%1: is no folder; accepted: a folder with models",
                arguments.folder);
  mcp::WorkplaceOptions out = agent_options(arguments.foreign, arguments.settle, common);
  out.folder = arguments.folder;
  out.run.context.detector = &detector;
  return out;
}

// The request that the line names, if it cancels one.
CancellableLines::Cancelled cancelled_requests(const std::string& line) {
  const mcp::Json id = mcp::cancelled_id(line);
  if (id.is_null()) return {};
  return [id](const std::string& earlier) { return mcp::id_of(earlier) == id; };
}

int serve_agent(const McpArguments& arguments, const CommonOptions& common) {
  const std::unique_ptr<Detector> detector = make_detector(common);
  mcp::Server server(workplace_options(arguments, common, *detector),
                     {kLayoutSchema, kArrangeSchema});
  const auto answer = [&](const InputLine& line) {
    return line.is_too_long ? std::optional(mcp::too_long_answer())
                            : server.answer(line.text, line.cancelled);
  };
  answer_lines(cancelled_requests, mcp::kMostLineBytes, answer,
               TRIVET_SENTENCE("the answers cannot be written to the standard output"));
  return 0;
}

}  // namespace

std::vector<Verb> add_mcp(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "mcp",
      "Let an agent lay out scenes: a server of the Model Context Protocol over standard input and "
      "output. Its tools are the operations of layouts, and open, list, look, check, mend, settle, "
      "move_joint, undo, redo and save; it reads and writes files in one folder only, and "
      "overwrites none but its own");
  const auto arguments = std::make_shared<McpArguments>();
  verb->add_option("folder", arguments->folder,
                   "Folder with models and scenes; default: the current one")
      ->type_name("FOLDER");
  add_foreign_options(*verb, arguments->foreign);
  add_settle_options(*verb, arguments->settle);
  return {{verb, [arguments, &common] { return serve_agent(*arguments, common); },
           "trivet mcp models < requests.jsonl\n"
           "trivet mcp models --operation-seconds 20 < requests.jsonl\n"}};
}

}  // namespace trivet::apps
