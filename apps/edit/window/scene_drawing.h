// Common drawing of all views: objects with their states, the ghost, contacts, highlights of a
// refusal, and playback.
#pragma once

#include <QElapsedTimer>
#include <QObject>

#include "apps/edit/document/document.h"
#include "apps/edit/tools/toolbox.h"
#include "apps/edit/window/playback.h"
#include "apps/edit/window/theme.h"

namespace trivet::edit {

struct DrawingOptions {
  bool shadows = true;
  bool contacts = true;        // of the active object
  bool watch_settling = true;  // otherwise objects jump to their resting pose
};

class SceneDrawing : public QObject {
  Q_OBJECT

 public:
  SceneDrawing(Document& document, Toolbox& toolbox, QObject* parent = nullptr);

  LiveScene scene(const View& view) const;
  const Theme& theme() const { return m_theme; }
  void set_theme(const Theme& theme);
  const DrawingOptions& options() const { return m_options; }
  void set_options(const DrawingOptions& options);

  /// True if anything moves, so that drafts suffice. What is held still does not.
  bool is_moving() const;
  /// True while a playback is running.
  bool is_playing() const { return m_playback.is_on(); }
  Pose seen_pose(const ObjectSnapshot& object) const { return m_playback.pose_of(object); }
  /// Highlights the objects and points of a message, until the next one.
  void light(const Message& message);
  void put_out_lights();

 Q_SIGNALS:
  void changed();

 private:
  void follow_document();
  bool is_dragged(ObjectId id) const;
  bool stops_drag(const ObjectSnapshot& object) const;
  bool is_lit(ObjectId id) const;  // by a message
  LiveColour tint_of(const ObjectSnapshot& object) const;
  LiveColour look_of(const ObjectSnapshot& object) const;
  void add_in_the_way(const ObjectSnapshot& object, LiveScene& scene) const;
  void add_ghost(LiveScene& scene) const;

  // scene_marks.cpp
  void add_active(LiveOverlay& overlay, const View& view) const;
  void add_gravity_line(LiveOverlay& overlay, const SceneSnapshot& scene, const Vec3& centre) const;
  void add_hull(LiveOverlay& overlay, const Contact& contact) const;
  void add_contact(LiveOverlay& overlay, const Object& object, const Contact& contact,
                   const View& view) const;
  void add_volume(LiveOverlay& overlay, const ProjectionVolume& volume) const;
  void add_drag(LiveOverlay& overlay) const;
  void add_playback(LiveOverlay& overlay) const;
  void add_interference(LiveOverlay& overlay) const;
  void add_crossing(LiveOverlay& overlay, const InterferingFaces& faces) const;
  void add_patch(LiveOverlay& overlay, const InterferingFaces& faces, const Vec3& at) const;
  void add_toppling(LiveOverlay& overlay, const View& view) const;
  void add_zlists(LiveOverlay& overlay) const;
  void add_tool(LiveOverlay& overlay, const View& view) const;

  Document& m_document;
  Toolbox& m_toolbox;
  Theme m_theme;
  DrawingOptions m_options;
  Message m_lit;
  std::shared_ptr<const SceneSnapshot> m_before;
  Playback m_playback;
  QElapsedTimer m_ghost_moved, m_drag_moved;
};

}  // namespace trivet::edit
