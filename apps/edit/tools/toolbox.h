// All tools, of which one is in the hand; what windows give their events to.
#pragma once

#include <functional>
#include <memory>

#include "apps/edit/tools/tool.h"

namespace trivet::edit {

class Toolbox {
 public:
  /// @param document  outlives this.
  explicit Toolbox(Document& document);
  ~Toolbox();

  ToolKind current() const { return m_current; }
  void take(ToolKind kind);  // cancels what the old one was at
  Tool& tool() { return *m_tool; }
  ToolOptions& options() { return m_options; }

  /// @return whether it was taken; else it is the window's (its camera's).
  bool pointer(const PointerEvent& event);
  /// Escape cancels, Delete deletes; letters take tools and do what needs no mouse, see README.
  bool key(const KeyEvent& event);

  // What keys and menus do; false: there is nothing to do it with.
  bool put_at_pointer();  // the active object, where the mouse was last
  bool pick_up();         // the active object, by ToolOptions::pick_up_distance
  bool erase_selected();

  Overlay overlay(const View& view) const { return m_tool->overlay(view); }
  Cursor cursor() const;
  std::string hint() const { return m_tool->hint(); }
  /// The last event that any window gave; for what a key does where the mouse points.
  const std::optional<PointerEvent>& last_pointer() const { return m_last; }

  /// Told when overlay, cursor or hint may be others: windows draw anew.
  std::function<void()> changed;

 private:
  Document& m_document;
  ToolOptions m_options;
  ToolKind m_current = ToolKind::Select;
  std::unique_ptr<Tool> m_tool;
  std::optional<PointerEvent> m_last;
};

}  // namespace trivet::edit
