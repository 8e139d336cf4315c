#include "apps/trivet/cancellable_lines.h"
#include "apps/trivet/foreign_scenes.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "ops/session/dialogue.h"
#include "ops/session/others.h"

namespace trivet::apps {
namespace {

struct SessionArguments {
  std::string start;
  NewJournal journal;
  ForeignArguments foreign;
  SettleArguments settle;
};

OpenedSession open(const SessionArguments& arguments, const CommonOptions& common,
                   Detector& detector) {
  RunOptions options = run_options(common, arguments.settle, &detector);
  if (!arguments.start.empty() && is_of_others(arguments.start)) {
    if (!arguments.journal.path.empty())
      throw Error(Error::Kind::BadInput,
                  "--journal: is for layouts and scenes of Trivet, and %1 is of another program",
                  arguments.start);
    return open_session_of_others(arguments.start, open_options(arguments.foreign, common),
                                  options.settle);
  }
  if (!arguments.start.empty())
    return open_session(arguments.start, options, common.limits(), arguments.journal);
  if (arguments.journal.path.empty())
    throw Error(Error::Kind::BadInput,
                "missing START; accepted: a layout, a scene, or --journal to restore");
  RestoredSession restored =
      restore_session(arguments.journal.path, options, common.limits(), true);
  if (!restored.exact)
    throw Error(Error::Kind::BadInput, "%1; `trivet replay` writes the scene as it was recorded",
                restored.opened.notes.back());
  return std::move(restored.opened);
}

DialogueOptions dialogue_options(const SessionArguments& arguments, Detector& detector) {
  DialogueOptions options;
  options.settle = arguments.settle.settle;
  options.context.detector = &detector;
  options.context.time_budget_s = arguments.settle.operation_seconds;
  options.version = TRIVET_VERSION;
  options.source = "standard input";
  return options;
}

constexpr const char* kLostAnswers = TRIVET_SENTENCE(
    "the answers of the session cannot be written to the standard output; it ends after the last "
    "step that was done");

CancellableLines::Cancelled all_before_cancel(const std::string& line) {
  return is_cancel_line(line) ? [](const std::string&) { return true; }
                              : CancellableLines::Cancelled();
}

int session(const SessionArguments& arguments, const CommonOptions& common) {
  const std::unique_ptr<Detector> detector = make_detector(common);
  OpenedSession opened = open(arguments, common, *detector);
  clear_progress_line(common);
  for (const Sentence& note : opened.notes) print_note(common, note);
  Dialogue dialogue(opened, dialogue_options(arguments, *detector));
  write_answer(dialogue.greeting().text, kLostAnswers);
  answer_lines(
      all_before_cancel, 0,
      [&](const InputLine& line) {
        return std::optional(dialogue.answer(line.text, line.cancelled).text);
      },
      kLostAnswers);
  tell_work(*detector, common, nullptr);
  return 0;
}

}  // namespace

std::vector<Verb> add_session(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "session",
      "Run operations interactively: each line of JSON on standard input is answered by a line on "
      "standard output; the first line of output greets. A line is an operation as in a layout, "
      "{\"do\": [operations]} for several as one step, {\"undo\": true}, {\"redo\": true}, "
      "{\"mend\": true}, {\"settle\": true}, {\"move_joint\": \"NAME\", \"to\": VALUE}, "
      "{\"save\": \"x.glb\"}, {\"query\": \"NAME\"} for an object, {\"query\": \"objects\"} for "
      "all, {\"query\": \"joints\"}, {\"query\": \"check\"}, or {\"cancel\": true}, which stops "
      "unfinished operations before it. An "
      "\"id\" in a line, text or a number, comes back in its answer. Answers have \"status\" (ok, "
      "refused, cancelled, out of time, error) and \"reason\", or the number of steps done and "
      "\"poses\" of all that moved, came or went");
  const auto arguments = std::make_shared<SessionArguments>();
  verb->add_option("start", arguments->start,
                   "Initial layout or scene, of another program, too; default: restore the journal")
      ->type_name("SCENE|LAYOUT.json");
  verb->add_option("--journal", arguments->journal.path,
                   "Record every step on disk, so that a crashed session can be restored");
  verb->add_flag("--keep-models", arguments->journal.keep_models,
                 "Keep the models beside the journal, too, for a session that is restored after "
                 "their files have changed")
      ->needs("--journal");
  add_foreign_options(*verb, arguments->foreign);
  add_settle_options(*verb, arguments->settle);
  return {{verb, [arguments, &common] { return session(*arguments, common); },
           "echo '{\"query\": \"objects\"}' | trivet session scene.glb\n"
           "trivet session layout.json --journal session < operations.jsonl\n"}};
}

}  // namespace trivet::apps
