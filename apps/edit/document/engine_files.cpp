// File jobs of the document's thread.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>

#include "apps/demo/arranged.h"
#include "apps/demo/demo.h"
#include "apps/edit/document/engine.h"
#include "apps/edit/document/layout_paths.h"
#include "apps/edit/document/words.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/base/quoted.h"
#include "core/io/atomic_file.h"
#include "core/io/export.h"
#include "core/io/overwrites.h"
#include "ops/base/names.h"
#include "ops/files/layout/paths.h"
#include "ops/files/report/scene_file.h"
#include "ops/session/journal.h"
#include "ops/simulation/scene_formats.h"

namespace trivet::edit {
namespace {

namespace fs = std::filesystem;

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Error(Error::Kind::Environment, "%1: cannot be created: %2", folder,
                error.message().c_str());
}

/// The models and the layout. @return the layout's file.
std::string write_demo(const std::vector<DemoModel>& models, const std::string& layout,
                       const std::string& folder) {
  for (const DemoModel& made : models) {
    ExportScene scene;
    scene.objects.push_back({fs::path(made.file).stem().string(),
                             std::make_shared<const Model>(made.model), Affine{}, ""});
    write_scene(scene, (fs::path(folder) / made.file).string());
  }
  const std::string file = (fs::path(folder) / "layout.json").string();
  write_file_atomically(file, layout);
  return file;
}

/// A demo that is arranged has its constraints, and objects that are not placed yet.
std::string write_demo(const std::string& name, const std::string& folder) {
  const std::vector<std::string> arranged = arranged_demo_names();
  if (std::find(arranged.begin(), arranged.end(), name) != arranged.end()) {
    const ArrangedDemo demo = make_arranged_demo(name);
    return write_demo(demo.models, demo.problem, folder);
  }
  const DemoLayout demo = make_demo(name);
  return write_demo(demo.models, layout_json(demo), folder);
}

// Name after the model's file, unique in the scene.
std::string new_name(const Scene& scene, const std::string& wanted) {
  std::string name = is_object_name(wanted) ? wanted : "object";
  for (int i = 2; scene.find(name); ++i)
    name = (is_object_name(wanted) ? wanted : "object") + "_" + std::to_string(i);
  return name;
}

}  // namespace

// A name never used by another session.
std::string Engine::new_journal() const {
  if (m_options.recovery_folder.empty()) return "";
  make_folder(m_options.recovery_folder);
  static std::atomic<int> counter = 0;
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  std::string name = "session-" + std::to_string(now) + "-" + std::to_string(getpid());
  name.append("-").append(std::to_string(++counter)).append(".journal");
  return (fs::path(m_options.recovery_folder) / name).string();
}

std::unique_ptr<FileLock> Engine::locked(const std::string& file) const {
  if (m_options.recovery_folder.empty()) return nullptr;
  if (m_lock && m_lock->file() == file) return nullptr;  // already locked by this document
  return std::make_unique<FileLock>((fs::path(m_options.recovery_folder) / "locks").string(), file);
}

void Engine::adopt(OpenedSession opened, const std::string& file, const std::string& title,
                   std::unique_ptr<FileLock> lock) {
  m_live.reset();
  leave_session();
  m_opened.emplace(std::move(opened));
  m_opened->session.on_event(
      [this](const SessionEvent& event) { m_snapshots.note_changed(event.changed); });
  m_look_steps = {};
  m_file = file;
  m_title = title;
  m_lock = std::move(lock);
  m_snapshots.forget();
  tell([scene = ++m_scene, wishes = m_opened->session.arrange()](EngineNews& shown) {
    shown.forget_scene(scene);
    shown.show_wishes(wishes);
  });
  publish();
  tell([looks = m_opened->session.layout().looks](EngineNews& shown) { shown.show_looks(looks); });
  for (const Sentence& note : m_opened->notes)
    tell(Message{Message::Kind::Info, in_words(note), {}, {}});
}

// Removes the recovery files, which are no longer needed.
void Engine::leave_session() {
  if (!m_opened) return;
  std::string journal;
  if (const Journal* const kept = m_opened->session.journal()) journal = kept->path();
  m_opened.reset();
  if (!journal.empty()) remove_recovery_files(journal);
}

bool Engine::new_scene() {
  const std::string journal = new_journal();
  OpenedSession opened{Session(Scene(), Layout(), models_in_folder("")), "", "", 0, {}};
  if (!journal.empty()) {
    const std::string start = journal + ".json";
    write_file_atomically(start, write_layout(Layout()));
    opened = open_session(start, run_options(), m_options.limits, {journal});
  }
  adopt(std::move(opened), "", "Untitled", nullptr);
  return true;
}

bool Engine::open(const std::string& file) {
  auto lock = locked(file);
  if (!lock && m_lock && m_lock->file() == file) lock = std::move(m_lock);
  const std::string extension = lower_extension(file);
  try {
    if (extension != ".glb" && extension != ".json")
      throw Error(
          Error::Kind::BadInput,
          "%1: cannot be opened; accepted: a scene (.glb) written by Trivet, or a layout (.json)",
          file);
    OpenedSession opened = open_session(file, run_options(), m_options.limits, {new_journal()});
    adopt(std::move(opened), extension == ".glb" ? file : "", fs::path(file).filename().string(),
          std::move(lock));
  } catch (...) {
    if (lock && m_file == file) m_lock = std::move(lock);
    throw;
  }
  return true;
}

bool Engine::open_demo(const std::string& name) {
  if (m_options.recovery_folder.empty())
    throw Error(Error::Kind::Environment,
                "demos need a recovery folder for their files, "
                "and this editor has none");
  const std::string folder = (fs::path(m_options.recovery_folder) / "demos" / name).string();
  make_folder(folder);
  const std::string layout = write_demo(name, folder);
  adopt(open_session(layout, run_options(), m_options.limits, {new_journal()}), "", name, nullptr);
  return true;
}

// From here on they are part of the layout.
SceneLooks Engine::keep_looks(const Looks& looks) {
  const Scene& scene = m_opened->session.scene();
  SceneLooks out = looks.named(
      [&](ObjectId id) { return scene.contains(id) ? scene.at(id).name : std::string(); });
  m_opened->session.set_looks(out);
  return out;
}

bool Engine::save_as(const std::string& file, const Looks& looks) {
  const std::string extension = lower_extension(file);
  const SceneLooks kept = keep_looks(looks);
  if (extension == ".json") {
    write_file_atomically(file,
                          write_layout(moved_layout(m_opened->session.layout(),
                                                    folder_from(file, m_opened->model_folder))));
    return true;
  }
  if (extension != ".glb")
    throw Error(Error::Kind::BadInput,
                "%1: cannot be saved; accepted: a file name ending in .glb or .json", file);
  auto lock = locked(file);
  save_session(*m_opened, m_options.version, file);
  if (lock) m_lock = std::move(lock);
  m_file = file;
  m_title = fs::path(file).filename().string();
  tell([kept](EngineNews& shown) { shown.show_saved_looks(kept); });
  publish();
  return true;
}

bool Engine::export_to(const std::string& file, const Looks& looks) {
  keep_looks(looks);
  check_not_an_input(file, model_files(m_opened->session.layout(), m_opened->model_folder));
  SceneFileOptions options;
  options.version = m_options.version;
  options.clearance = settled_clearance(*m_opened);
  options.model_folder = folder_from(file, m_opened->model_folder);
  write_in_any_format(m_opened->session.scene(), m_opened->session.layout(), options, file);
  return true;
}

bool Engine::close() {
  leave_session();
  m_lock.reset();
  OpenedSession opened{Session(Scene(), Layout(), models_in_folder("")), "", "", 0, {}};
  adopt(std::move(opened), "", "Untitled", nullptr);
  return true;
}

bool Engine::restore(const std::string& journal) {
  RestoredSession restored = restore_session(journal, run_options(), m_options.limits, true);
  const JournalContent content = read_journal(journal);
  std::string file = saved_file_of(journal, content);
  std::unique_ptr<FileLock> lock;
  if (!file.empty()) lock = locked(file);
  adopt(std::move(restored.opened), file,
        file.empty() ? "Untitled" : fs::path(file).filename().string(), std::move(lock));
  return restored.exact;
}

// Follows the scene's own models: relative if the file lies below their folder.
std::string Engine::model_path(const std::string& file) const {
  const std::string folder = m_opened->model_folder;
  const fs::path whole = fs::absolute(file).lexically_normal();
  const fs::path way =
      whole.lexically_relative(fs::absolute(folder.empty() ? "." : folder).lexically_normal());
  if (way.empty() || *way.begin() == "..") return whole.generic_string();
  return way.generic_string();
}

bool Engine::import_model(const ImportModel& model) {
  const Scene& scene = m_opened->session.scene();
  AppendOperation append;
  append.object =
      new_name(scene, model.name.empty() ? fs::path(model.file).stem().string() : model.name);
  append.model = model_path(model.file);
  append.scale = model.scale;
  append.up = model.up;
  append.fixed = model.fixed;
  const std::vector<std::string> select{append.object};
  PutOperation put;
  put.object = append.object;
  if (model.put) put.start = *model.put;
  const bool is_done =
      (model.put && perform_all({append, put}, select)) || perform_all({append}, select);
  if (is_done) tell_notes(append.object);
  return is_done;
}

// On what its file has and is left out.
void Engine::tell_notes(const std::string& object) {
  const Scene& scene = m_opened->session.scene();
  const auto id = scene.find(object);
  const std::shared_ptr<const Model> model = id ? scene.at(*id).model : nullptr;
  if (!model || model->notes.empty()) return;
  std::string text = quoted(object) + ": ";
  for (const Sentence& note : model->notes)
    text += (&note == &model->notes.front() ? "" : "; ") + in_words(note);
  tell(Message{Message::Kind::Info, text, {}, {}});
}

}  // namespace trivet::edit
