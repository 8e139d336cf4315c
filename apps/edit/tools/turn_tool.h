// TURN with the mouse: a click on a contact's point, edge or area holds it; dragging turns about
// it.
#pragma once

#include "apps/edit/tools/drag_tool.h"
#include "apps/edit/tools/turning.h"
#include "ops/operations/turn_axis.h"

namespace trivet::edit {

class TurnTool : public DragTool {
 public:
  using DragTool::DragTool;
  ToolKind kind() const override { return ToolKind::Turn; }
  std::string hint() const override;
  Overlay overlay(const View& view) const override;

 protected:
  bool grab(const PointerEvent& event) override;
  std::optional<Operation> begin() override;
  void steer(const PointerEvent& event) override;
  TypedNumbers numbers() const override { return {{""}, 0, "°"}; }
  void steer_by(const std::vector<double>& values) override;
  void hover(const PointerEvent& event) override;

 private:
  std::optional<ActiveContact> m_hovered;
  std::optional<TurnAxis> m_axis;  // during a turn
  Turning m_turning;
};

/// TURN about an active contact. @param view_axis  axis through a held point.
TurnOperation turn_about(const SceneSnapshot& scene, const Selection& selection,
                         const Vec3& view_axis);

}  // namespace trivet::edit
