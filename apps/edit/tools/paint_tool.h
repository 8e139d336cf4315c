// PAINT: a stroke over surfaces sets down copies of the selected objects along it, as one step.
#pragma once

#include <chrono>

#include "apps/edit/tools/tool.h"

namespace trivet::edit {

class PaintTool : public Tool {
 public:
  PaintTool(Document& document, const ToolOptions& options)
      : m_document(document), m_options(options) {}

  ToolKind kind() const override { return ToolKind::Paint; }
  bool pointer(const PointerEvent& event) override;
  bool key(const KeyEvent& event) override;
  void cancel() override;
  bool is_active() const override { return m_pressed.has_value(); }
  Overlay overlay(const View& view) const override;
  Cursor cursor() const override;
  std::string hint() const override;
  std::string in_hand() const override;

 private:
  std::vector<std::string> objects() const;
  double spacing() const;
  std::vector<Vec3> places() const;
  std::vector<Vec3> poured() const;
  void paint_to(const PointerEvent& event);
  void finish();

  Document& m_document;
  const ToolOptions& m_options;
  std::optional<PointerEvent> m_pressed;
  Vec2 m_last = Vec2::Zero();  // pixels, end of the stroke
  std::vector<Vec3> m_stroke;  // world, on surfaces
  std::uint64_t m_strokes = 0;
  std::chrono::steady_clock::time_point m_began;
};

}  // namespace trivet::edit
