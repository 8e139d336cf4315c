// TRANSLATE and ROTATE by the gizmo; dragging the object itself moves it in the view plane.
#pragma once

#include "apps/edit/tools/drag_tool.h"
#include "apps/edit/tools/gizmo.h"
#include "apps/edit/tools/turning.h"

namespace trivet::edit {

class GizmoTool : public DragTool {
 public:
  GizmoTool(Document& document, const ToolOptions& options, bool turns)
      : DragTool(document, options), m_turns(turns) {}
  ToolKind kind() const override { return m_turns ? ToolKind::Rotate : ToolKind::Move; }
  std::string hint() const override;
  Overlay overlay(const View& view) const override;
  void cancel() override;

 protected:
  bool grab(const PointerEvent& event) override;
  std::optional<Operation> begin() override;
  bool start(const PointerEvent& event) override;
  bool follows() const override { return m_lifted || m_document.is_dragging(); }
  void end() override;
  void give_back() override;
  void steer(const PointerEvent& event) override;
  TypedNumbers numbers() const override;
  void steer_by(const std::vector<double>& values) override;
  void hover(const PointerEvent& event) override;

 private:
  std::optional<Gizmo> gizmo() const;
  Vec3 way(const PointerEvent& event) const;
  Vec3 snapped(const PointerEvent& event, Vec3 goal);
  void show_ghost();
  void turn_to(double degrees);
  std::vector<Operation> choices() const;

  bool m_turns;
  std::optional<GizmoHandle> m_hot;  // under the mouse, or being dragged
  Vec3 m_axis = Vec3::UnitZ();       // of the dragged handle
  Turning m_turning;
  std::shared_ptr<const Object> m_lifted;  // as it was; null: it is not lifted to be turned
  ObjectId m_lifted_id;
  double m_degrees = 0;
};

}  // namespace trivet::edit
