#include "ops/session/restore.h"

#include <filesystem>

#include "core/base/error.h"
#include "core/io/overwrites.h"
#include "core/scene/fingerprint.h"
#include "ops/files/layout/paths.h"
#include "ops/files/report/scene_file.h"
#include "ops/placement/clearance.h"
#include "ops/session/journal.h"
#include "ops/session/others.h"
#include "ops/session/recorded_sources.h"
#include "ops/session/start.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

// The start file under one of its names: the journal's own copy first, which nobody else writes.
std::string find_start(const std::string& journal, const JournalStart& start,
                       const std::string& file) {
  for (const std::string& name : {start_copy_of(journal), file}) {
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

/// A session on its way: exact, until something differs; from there on by the recorded poses.
class Restoring {
 public:
  Restoring(const std::string& journal, const JournalContent& content, const RunOptions& options,
            const ImportLimits& limits)
      : m_journal(journal),
        m_content(content),
        m_options(options),
        m_file((fs::path(folder_of(journal)) / content.start.file).lexically_normal().string()),
        m_sources(std::make_shared<RecordedSources>(journal,
                                                    models_in_folder(folder_of(m_file), limits))),
        m_opened(open(limits)) {
    if (content.torn())
      m_opened.notes.push_back(
          say("the last line of \"%1\" is torn: its operation was never committed, and is left out",
              journal));
  }

  /// One line of the journal. @return false: it cannot be done again.
  bool repeat(size_t i) {
    const JournalRecord& record = m_content.records[i];
    m_sources->expect(record.models);
    if (m_exact && repeat_exactly(record)) return true;
    if (m_exact) lose_exactness(say("line %1: %2", i + 2, m_why));
    if (m_stands && repeat_as_recorded(record)) return true;
    m_stop = say("line %1: %2", i + 2, m_why);
    return false;
  }

  RestoredSession take() {
    for (Sentence& note : m_sources->notes()) m_opened.notes.push_back(std::move(note));
    m_sources->end();
    if (m_exact && m_differs)
      m_opened.notes.push_back(say(
          "\"%1\" is of an earlier version, and its steps are done again by this one", m_journal));
    if (!m_exact && m_stop.empty())
      m_opened.notes.push_back(
          say("poses of \"%1\" are as they were recorded: %2", m_journal, m_first_difference));
    if (!m_stop.empty())
      m_opened.notes.push_back(say("\"%1\" is restored up to here: %2", m_journal, m_stop));
    return {std::move(m_opened), m_exact};
  }

 private:
  OpenedSession open(const ImportLimits& limits);
  bool repeat_exactly(const JournalRecord& record);
  bool repeat_as_recorded(const JournalRecord& record);
  bool perform(const JournalRecord& record);
  bool step_over(const JournalRecord& record);
  // Last bits and ratings differ between versions; recorded poses, which tell more, came later.
  bool is_as_recorded(std::uint64_t state, std::uint64_t recorded) {
    m_differs = m_differs || state != recorded;
    return state == recorded || m_content.start.of_earlier_version;
  }
  void lose_exactness(Sentence why) {
    m_exact = false;
    m_first_difference = std::move(why);
  }

  const std::string& m_journal;
  const JournalContent& m_content;
  const RunOptions& m_options;
  const std::string m_file;
  const std::shared_ptr<RecordedSources> m_sources;
  bool m_exact = true, m_stands = true;  // false: the start itself is not as it was
  bool m_differs = false;                // a state
  Sentence m_why, m_first_difference, m_stop;
  OpenedSession m_opened;
};

OpenedSession Restoring::open(const ImportLimits& limits) {
  const JournalStart& start = m_content.start;
  const std::string content = find_start(m_journal, start, m_file);
  RunOptions options = m_options;
  options.settle = start.settle;
  options.rules = rules_of(start.settle);
  m_sources->expect(start.models);
  const ModelSource models = [sources = m_sources](const std::string& name,
                                                   const Tessellation& tessellation) {
    return sources->model(name, tessellation);
  };
  OpenedSession opened = open_start(content, m_file, models, options, limits);
  if (is_as_recorded(fingerprint(opened.session.scene()), start.state)) return opened;
  lose_exactness(say("\"%1\" does not give the same scene to the bit", m_file));
  if (start.poses)
    return open_recorded_layout(content, m_file, models, *start.poses, options, limits);
  m_stands = !is_layout(m_file);  // a scene file has its poses
  m_why = m_first_difference;
  return opened;
}

bool Restoring::step_over(const JournalRecord& record) {
  Session& session = m_opened.session;
  if (record.kind == JournalRecord::Kind::Saved) {
    session.mark_saved(record.file);
    return true;
  }
  const bool done = record.kind == JournalRecord::Kind::Undo ? session.undo() : session.redo();
  if (!done) m_why = TRIVET_SENTENCE("there is nothing to undo or redo");
  return done;
}

bool Restoring::repeat_as_recorded(const JournalRecord& record) {
  if (record.kind != JournalRecord::Kind::Step) return step_over(record);
  if (!record.poses) return false;
  if (record.operations.empty())
    m_opened.session.place("move", *record.poses, record.settle);
  else
    m_opened.session.repeat(record.operations, record.settle, *record.poses);
  return true;
}

bool Restoring::perform(const JournalRecord& record) {
  try {
    if (record.operations.empty()) {
      m_opened.session.place("move", *record.poses, record.settle);
      return true;
    }
    const OperationResult result =
        m_opened.session.perform_all(record.operations, record.settle, m_options.context);
    m_why = result.refusal ? sentence_of(*result.refusal) : Sentence();
    return result.ok();
  } catch (const Error& e) {  // a model that cannot be read
    m_why = e.sentence();
    return false;
  }
}

// @return whether it gave the same bits; else the session is as before.
bool Restoring::repeat_exactly(const JournalRecord& record) {
  Session& session = m_opened.session;
  std::vector<ObjectId> changed;
  session.on_event([&](const SessionEvent& event) { changed = event.changed; });
  const bool done = record.kind == JournalRecord::Kind::Step ? perform(record) : step_over(record);
  session.on_event({});
  if (!done) return false;
  if (record.kind == JournalRecord::Kind::Saved) return true;
  if (is_as_recorded(fingerprint(session.scene(), changed), record.state)) return true;
  m_why = TRIVET_SENTENCE("the result is not the same to the bit");
  if (record.kind == JournalRecord::Kind::Undo)
    session.redo();
  else
    session.undo();
  return false;
}

}  // namespace

OpenedSession open_session(const std::string& file, const RunOptions& options,
                           const ImportLimits& limits, const NewJournal& journal) {
  const ModelSource models = models_in_folder(folder_of(file), limits);
  if (journal.path.empty()) return open_start(file, file, models, options, limits);
  JournalStart start;
  start.file = file;
  start.hash = hash_of_file(file, start.bytes);
  OpenedSession opened = open_start(file, file, models, options, limits);
  const Scene& scene = opened.session.scene();
  start.settle = with_rules(options.settle, opened.rules);
  start.state = fingerprint(scene);
  if (is_layout(file)) start.poses = recorded_poses(scene, scene.ids());
  start.keep_models = journal.keep_models;
  opened.session.keep_journal(Journal::create(journal.path, std::move(start), scene));
  return opened;
}

OpenedSession copy_of(const OpenedSession& opened, const ImportLimits& limits) {
  return {Session(opened.session.scene(), opened.session.layout(),
                  models_in_folder(opened.model_folder, limits)),
          opened.start_file,
          opened.model_folder,
          opened.clearance,
          {},
          opened.rules,
          opened.others ? std::make_shared<OthersScene>(*opened.others) : nullptr};
}

RestoredSession restore_session(const std::string& journal, const RunOptions& options,
                                const ImportLimits& limits, bool go_on) {
  const JournalContent content = read_journal(journal);
  std::unique_ptr<Journal> reopened = go_on ? Journal::reopen(journal, content) : nullptr;
  Restoring restoring(journal, content, options, limits);
  for (size_t i = 0; i < content.records.size(); ++i) {
    if (options.progress) options.progress({"replay", journal, i, content.records.size()});
    if (!restoring.repeat(i)) break;
  }
  RestoredSession restored = restoring.take();
  if (restored.exact && reopened) {
    reopened->set_recorded(restored.opened.session.scene());
    restored.opened.session.keep_journal(std::move(reopened));
  }
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
  if (const Journal* const journal = opened.session.journal())
    inputs.insert(inputs.end(), {journal->path(), start_copy_of(journal->path())});
  check_not_an_input(path, inputs);
  SceneFileOptions options;
  options.version = version;
  options.clearance = settled_clearance(opened);
  options.model_folder = folder_from(path, opened.model_folder);
  write_scene_file(opened.session.scene(), opened.session.layout(), options, path);
  opened.session.mark_saved(path);
}

}  // namespace trivet
