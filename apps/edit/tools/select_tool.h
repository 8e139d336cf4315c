// Selection and direct moves: a click selects, with Shift or Control adds; a drag moves an object
// that may move, and from anywhere else, or with Shift and Control, draws a box that selects.
#pragma once

#include "apps/edit/tools/drag_tool.h"
#include "apps/edit/tools/hand_gesture.h"

namespace trivet::edit {

class SelectTool : public DragTool {
 public:
  SelectTool(Document& document, const ToolOptions& options)
      : DragTool(document, options), m_gesture(document, options) {}

  ToolKind kind() const override { return ToolKind::Select; }
  bool key(const KeyEvent& event) override;
  bool wants_key(const KeyEvent& event) const override;
  Overlay overlay(const View& view) const override;
  Cursor cursor() const override;
  std::string hint() const override;

 protected:
  bool waits() const override { return false; }
  bool grab(const PointerEvent& event) override;
  bool start(const PointerEvent& event) override;
  bool follows() const override { return true; }
  void steer(const PointerEvent& event) override;
  void end() override;
  void give_back() override;
  bool pulls_links(const PointerEvent& event) const override;
  void click(const PointerEvent& event) override;
  void hover(const PointerEvent& event) override;
  bool wheel(const PointerEvent& event) override;

 private:
  bool may_take(const PointerEvent& event) const;
  bool takes_at(const PointerEvent& event) const;
  void select_box();

  HandGesture m_gesture;
  bool m_hot = false;  // the mouse is over what a drag would move
  Vec2 m_now = Vec2::Zero();
};

}  // namespace trivet::edit
