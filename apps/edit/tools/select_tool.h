// Selection by click, Shift or Control to add, or by a box dragged from an empty place.
#pragma once

#include "apps/edit/tools/tool.h"

namespace trivet::edit {

class SelectTool : public Tool {
 public:
  explicit SelectTool(Document& document) : m_document(document) {}

  ToolKind kind() const override { return ToolKind::Select; }
  bool pointer(const PointerEvent& event) override;
  bool key(const KeyEvent& event) override;
  void cancel() override;
  bool is_active() const override { return m_pressed.has_value(); }
  Overlay overlay(const View& view) const override;
  Cursor cursor() const override { return Cursor::Arrow; }
  std::string hint() const override;

 private:
  void click(const PointerEvent& event);
  void select_box(const PointerEvent& event);

  Document& m_document;
  std::optional<PointerEvent> m_pressed;
  Vec2 m_now = Vec2::Zero();
  bool m_is_box = false;
};

}  // namespace trivet::edit
