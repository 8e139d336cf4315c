#include "ops/session/restore.h"

#include <filesystem>

#include "core/base/error.h"
#include "core/io/overwrites.h"
#include "core/scene/fingerprint.h"
#include "ops/check/check.h"
#include "ops/files/layout/paths.h"
#include "ops/files/report/scene_file.h"
#include "ops/placement/clearance.h"
#include "ops/session/journal.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

// @param content  the file to read; `file` says what it is and where its models are.
OpenedSession open_start(const std::string& content, const std::string& file,
                         const RunOptions& options, const ImportLimits& limits) {
  const std::string folder = folder_of(file);
  const ModelSource models = models_in_folder(folder, limits);
  if (fs::path(file).extension() != ".json") {
    SceneFile scene = read_scene_file(content, limits, folder.empty() ? "." : folder);
    const SettleOptions settle = settle_options(options, scene.layout.settle);
    update_contacts(scene.scene, scene.clearance, settle);
    const SettleRules rules = rules_of(settle);
    scene.layout.settle = rules;
    return {Session(std::move(scene.scene), std::move(scene.layout), models),
            file,
            folder,
            scene.clearance,
            std::move(scene.notes),
            rules};
  }
  Layout layout = read_layout(content, limits.max_file_bytes);
  layout.settle = rules_of(settle_options(options, layout.settle));
  LayoutRun run = run_layout(layout, models, options);
  std::vector<Sentence> notes;
  for (const OperationRecord& record : run.operations)
    if (!record.result.ok())
      notes.push_back(say("%1 \"%2\": refused: %3", record.op, record.object,
                          sentence_of(*record.result.refusal)));
  const SettleRules rules = layout.settle;
  return {Session(std::move(run.scene), std::move(layout), models),
          file,
          folder,
          options.settle.clearance,
          std::move(notes),
          rules};
}

// The start file under one of its names.
std::string find_start(const std::string& journal, const JournalStart& start,
                       const std::string& file) {
  for (const std::string& name : {file, start_copy_of(journal)}) {
    std::uintmax_t bytes = 0;
    std::error_code ignored;
    if (!fs::is_regular_file(name, ignored)) continue;
    if (hash_of_file(name, bytes) == start.hash && bytes == start.bytes) return name;
  }
  throw Error(Error::Kind::BadInput,
              "%1: neither \"%2\" nor \"%3\" is the file that the session began with; accepted: "
              "the same bytes",
              journal, file, start_copy_of(journal));
}

// One line of the journal done again. @return whether it gave the same bits.
bool replay(const JournalRecord& record, const RunOptions& options, Session& session,
            Sentence& why) {
  std::vector<ObjectId> changed;
  OperationResult result;
  session.on_event([&](const SessionEvent& event) { changed = event.changed; });
  bool done = true;
  switch (record.kind) {
    case JournalRecord::Kind::Saved:
      session.mark_saved(record.file);
      break;
    case JournalRecord::Kind::Undo:
      done = session.undo();
      break;
    case JournalRecord::Kind::Redo:
      done = session.redo();
      break;
    case JournalRecord::Kind::Step: {
      result = session.perform_all(record.operations, record.settle, options.context);
      done = result.ok();
      break;
    }
  }
  session.on_event({});
  if (!done) {
    why = result.refusal ? sentence_of(*result.refusal)
                         : TRIVET_SENTENCE("there is nothing to undo or redo");
    return false;
  }
  if (record.kind == JournalRecord::Kind::Saved) return true;
  if (fingerprint(session.scene(), changed) == record.state) return true;
  why = TRIVET_SENTENCE("the result is not the same to the bit");
  if (record.kind == JournalRecord::Kind::Redo)
    session.undo();
  else if (record.kind == JournalRecord::Kind::Undo)
    session.redo();
  else
    session.undo();
  return false;
}

}  // namespace

OpenedSession open_session(const std::string& file, const RunOptions& options,
                           const ImportLimits& limits, const std::string& journal) {
  OpenedSession opened = open_start(file, file, options, limits);
  if (!journal.empty())
    opened.session.keep_journal(Journal::create(journal, file,
                                                with_rules(options.settle, opened.rules),
                                                fingerprint(opened.session.scene())));
  return opened;
}

OpenedSession copy_of(const OpenedSession& opened, const ImportLimits& limits) {
  return {Session(opened.session.scene(), opened.session.layout(),
                  models_in_folder(opened.model_folder, limits)),
          opened.start_file,
          opened.model_folder,
          opened.clearance,
          {},
          opened.rules};
}

RestoredSession restore_session(const std::string& journal, const RunOptions& options,
                                const ImportLimits& limits, bool go_on) {
  const JournalContent content = read_journal(journal);
  std::unique_ptr<Journal> reopened = go_on ? Journal::reopen(journal, content) : nullptr;
  const std::string file =
      (fs::path(folder_of(journal)) / content.start.file).lexically_normal().string();
  const std::string start = find_start(journal, content.start, file);
  RunOptions start_options = options;
  start_options.settle = content.start.settle;
  start_options.rules = rules_of(content.start.settle);
  RestoredSession restored{open_start(start, file, start_options, limits), true};
  OpenedSession& opened = restored.opened;
  if (content.torn())
    opened.notes.push_back(
        say("the last line of \"%1\" is torn: its operation was never committed, and is left out",
            journal));
  Sentence why;
  restored.exact = fingerprint(opened.session.scene()) == content.start.state;
  if (!restored.exact) why = say("\"%1\" does not give the same scene to the bit", file);
  for (size_t i = 0; restored.exact && i < content.records.size(); ++i) {
    if (options.progress) options.progress({"replay", journal, i, content.records.size()});
    restored.exact = replay(content.records[i], options, opened.session, why);
    if (!restored.exact) why = say("line %1: %2", i + 2, why);
  }
  if (restored.exact)
    opened.session.keep_journal(std::move(reopened));
  else
    opened.notes.push_back(say("\"%1\" is restored up to here: %2", journal, why));
  return restored;
}

double settled_clearance(const OpenedSession& opened) {
  if (opened.clearance > 0) return opened.clearance;
  const double largest = opened.session.largest_clearance();
  return largest > default_clearance(opened.session.scene()) ? largest : 0;
}

std::string scene_bytes(const OpenedSession& opened, const std::string& version) {
  SceneFileOptions options;
  options.version = version;
  options.clearance = settled_clearance(opened);
  return scene_file_bytes(opened.session.scene(), opened.session.layout(), options);
}

void save_session(OpenedSession& opened, const std::string& version, const std::string& path) {
  std::vector<std::string> inputs = model_files(opened.session.layout(), opened.model_folder);
  if (const Journal* const journal = opened.session.journal()) inputs.push_back(journal->path());
  check_not_an_input(path, inputs);
  SceneFileOptions options;
  options.version = version;
  options.clearance = settled_clearance(opened);
  options.model_folder = folder_from(path, opened.model_folder);
  write_scene_file(opened.session.scene(), opened.session.layout(), options, path);
  opened.session.mark_saved(path);
}

}  // namespace trivet
