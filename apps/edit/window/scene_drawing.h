// What all views show of the document: objects with their states, the ghost, contacts, what a
// refusal lights; and objects on their way from one rest to the next.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <map>

#include "apps/edit/document/document.h"
#include "apps/edit/tools/toolbox.h"
#include "apps/edit/window/theme.h"

namespace trivet::edit {

struct DrawingOptions {
  bool shadows = true;
  bool contacts = true;        // of the active object
  bool watch_settling = true;  // else objects are at once where they come to rest
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

  /// Something moves: drafts will do.
  bool is_moving() const;
  /// Objects and points that a message is about, lit until the next.
  void light(const Message& message);
  void put_out_lights();

 Q_SIGNALS:
  void changed();

 private:
  struct Way {
    Pose from, to;
  };
  void follow_document();
  void move_on();
  double progress() const;  // of the motion, 0 to 1
  Pose shown_pose(const ObjectSnapshot& object) const;
  LiveColour tint_of(const ObjectSnapshot& object) const;
  void add_ghost(LiveScene& scene) const;
  void add_active(LiveScene& scene, const View& view) const;
  void add_contacts(LiveOverlay& overlay, const Object& object, const View& view) const;
  void add_drag(LiveScene& scene) const;
  void add_tool(LiveOverlay& overlay, const View& view) const;

  Document& m_document;
  Toolbox& m_toolbox;
  Theme m_theme;
  DrawingOptions m_options;
  Message m_lit;
  std::shared_ptr<const SceneSnapshot> m_before;
  std::map<std::uint32_t, Way> m_ways;  // by the object's slot
  QElapsedTimer m_since, m_ghost_moved;
  QTimer m_tick;
};

}  // namespace trivet::edit
