// Someone who lays out scenes by hand in the editor's window, and a judge of each gesture: it is
// one step, and undo brings back the bytes that were there.
#pragma once

#include <functional>

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Two places are the same, metres.
inline constexpr double kSlack = 1e-3;

class AtWork {
 public:
  /// @param folder  of the models, and for the scenes that are saved.
  AtWork(Document& document, MainWindow& window, User& user, const QString& folder);

  Document& document() { return m_document; }
  MainWindow& window() { return m_window; }
  User& user() { return m_user; }
  SceneView& view() { return m_window.view(WindowKind::Perspective); }
  const QString& folder() const { return m_folder; }

  // --- before the work ---------------------------------------------------------------------------

  void new_scene();
  void write_model(const QString& name, const std::vector<Aabb>& boxes);
  /// Imports `model` of the folder and puts it at `at`.
  void place(const std::string& name, const QString& model, const Vec3& at, bool fixed = false);
  /// Shows the boxes in the view. Nothing is selected, no tool is taken, and counting starts.
  void begin(const QString& job, const Aabb& shown);

  // --- the work ----------------------------------------------------------------------------------

  ObjectId id(const std::string& name) { return m_document.snapshot()->find(name)->id; }
  Aabb box(const std::string& name) { return world_box(m_user.object(name)); }
  Vec3 centre(const std::string& name) { return box(name).centre(); }
  /// A point at the height of an object's upper side.
  Vec3 on(const std::string& name, const Vec2& at);
  bool is_at_rest(const std::string& name);
  /// One gesture, judged. @return false: the test has failed.
  bool gesture(const std::function<void()>& act);
  /// By one drag, so that its foot points there.
  void drag(const std::string& name, const Vec3& to);
  void click_on(const std::string& name, Qt::KeyboardModifiers modifiers = {});

  // --- after the work ----------------------------------------------------------------------------

  /// Judged by `trivet check`, and undone to the bytes of the beginning. Prints the effort, and
  /// shows the result in windows of two sizes, dark and light.
  void end();
  User::Effort effort() const;

 private:
  std::string save(const QString& name);

  Document& m_document;
  MainWindow& m_window;
  User& m_user;
  QString m_folder, m_job;
  User::Effort m_before;
  size_t m_steps = 0;
  QByteArray m_bytes;
};

}  // namespace trivet::edit::test
