// An agent works on this: one open scene, and the files of one folder.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "apps/mcp/messages.h"
#include "core/io/model_folder.h"
#include "core/picture/scene.h"
#include "ops/files/foreign/open_scene.h"
#include "ops/session/dialogue.h"

namespace trivet::mcp {

/// The bytes of a PNG file. @param camera  nullopt: frames everything.
using DrawPng = std::function<std::string(const Scene& scene, const std::optional<Camera>& camera,
                                          int width, int height)>;

struct WorkplaceOptions {
  std::string folder;  // files are read and written in it and below it
  RunOptions run;
  OpenOptions others;  // its limits: of all files
  std::string version;
  DrawPng draw;
  size_t max_states = 200'000, max_objects = 20'000;  // of DialogueOptions
  bool saves = true;                                  // else no file is written
};

/// The outcome of a call.
// NOLINTNEXTLINE(bugprone-exception-escape): moving a Json asserts, it throws nothing.
struct Answer {
  std::string text;  // for the agent
  Json data = {};    // the same for programs; null: none
  std::string png = {};
  bool is_error = false;
};

class Workplace {
 public:
  explicit Workplace(WorkplaceOptions options);
  ~Workplace();

  /// @param cancelled  stops the calls that follow; outlives them.
  void use(const std::atomic<bool>& cancelled) { m_cancelled = &cancelled; }
  /// As Dialogue::use().
  void use(Detector* detector);

  /// The bytes that `save` writes, of a scene of Trivet's own.
  /// @throws Error (BadInput): no scene is open, or one of another program.
  std::string scene_file() const;

  /// An operation of layouts, with its arguments.
  Answer operation(const std::string& op, const JsonPlace& arguments);

  Answer open(const JsonPlace& arguments);
  Answer list(const JsonPlace& arguments);
  Answer look(const JsonPlace& arguments);
  Answer check(const JsonPlace& arguments);
  Answer move_joint(const JsonPlace& arguments);
  Answer mend(const JsonPlace& arguments);
  Answer settle(const JsonPlace& arguments);
  Answer undo(const JsonPlace& arguments);
  Answer redo(const JsonPlace& arguments);
  Answer save(const JsonPlace& arguments);

 private:
  struct Place {
    OpenedSession opened;
    Dialogue dialogue;

    Place(OpenedSession session, const DialogueOptions& options)
        : opened(std::move(session)), dialogue(opened, options) {}
  };

  OpenedSession opened_at(const std::string& file) const;
  OpenedSession empty_room() const;
  void enter(OpenedSession opened);
  Place& place() const;  // refuses when nothing is open
  const Scene& scene() const;
  Json ask(const Json& line) const;
  std::string inside(const JsonPlace& file) const;
  void check_model(const JsonPlace& arguments) const;
  Answer list_objects(size_t first) const;
  Answer list_files() const;
  Answer list_joints() const;
  Answer repaired(const char* what, const JsonPlace& arguments);
  Answer stepped(const char* what, const JsonPlace& arguments);

  WorkplaceOptions m_options;
  ModelFolder m_root;
  std::unique_ptr<Place> m_place;
  std::string m_name;               // of what is open, as the agent calls it
  std::set<std::string> m_written;  // by `save`: these may be written again
  const std::atomic<bool>* m_cancelled = nullptr;
};

}  // namespace trivet::mcp
