// All tools, one of them active; receives the events of the windows.
#pragma once

#include <functional>
#include <memory>

#include "apps/edit/tools/tool.h"

namespace trivet::edit {

class Toolbox {
 public:
  /// @param document  must outlive this object.
  explicit Toolbox(Document& document);
  ~Toolbox();

  ToolKind current() const { return m_current; }
  void take(ToolKind kind);  // cancels the previous tool's action
  Tool& tool() { return *m_tool; }
  ToolOptions& options() { return m_options; }
  const ToolOptions& options() const { return m_options; }

  /// @return whether it was consumed; otherwise it is for the window's camera.
  bool pointer(const PointerEvent& event);
  /// Escape cancels, Delete deletes; letters select tools and run commands without the mouse, see
  /// README.
  bool key(const KeyEvent& event);

  // Actions of keys and menus; false if there is no object for them.
  bool put_at_pointer();  // the active object, at the last position of the mouse
  bool take_next();       // into the hand of PUT: the next object that is not placed yet
  bool pick_up();         // the active object, by ToolOptions::pick_up_distance
  bool erase_selected();
  /// The active object lifted, laid otherwise, and settled; a message where it lies so already.
  bool lie(Lying how);
  /// The same, turned about the vertical by steps of ToolOptions::angle_step_deg.
  bool turn(int steps);
  /// The object selected before the active one leans against it.
  bool lean();
  bool next_contact();  // of the active object: what the constraint window looks along, and PUSH
                        // goes along

  Overlay overlay(const View& view) const { return m_tool->overlay(view); }
  Cursor cursor() const;
  std::string hint() const { return m_tool->hint(); }
  std::string reading() const { return m_tool->reading(); }
  bool wants_key(const KeyEvent& event) const { return m_tool->wants_key(event); }
  std::string in_hand() const { return m_tool->in_hand(); }
  /// The last event of any window, for keys that act at the mouse position.
  const std::optional<PointerEvent>& last_pointer() const { return m_last; }

  /// Called when overlay, cursor or hint may have changed: windows redraw.
  std::function<void()> changed;

 private:
  const ObjectSnapshot* idle_active() const;
  void put_turned(const ObjectSnapshot& object, const Rotation& rotation);
  void lie_as_found(const WaysToLie& ways);

  Document& m_document;
  ToolOptions m_options;
  std::optional<Lying> m_lying;  // asked for, until the ways are found
  QMetaObject::Connection m_ways;
  ToolKind m_current = ToolKind::Select;
  std::unique_ptr<Tool> m_tool;
  std::optional<PointerEvent> m_last;
};

}  // namespace trivet::edit
