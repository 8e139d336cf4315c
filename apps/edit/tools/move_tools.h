// PUT, PUSH and PICK-UP with the mouse.
#pragma once

#include "apps/edit/tools/drag_tool.h"

namespace trivet::edit {

/// PUT: previews the resting pose of the active object as a ghost; a click puts it there.
class PutTool : public DragTool {
 public:
  using DragTool::DragTool;
  ToolKind kind() const override { return ToolKind::Put; }
  std::string hint() const override;
  Cursor cursor() const override { return Cursor::Cross; }
  void cancel() override;

  /// Puts the active object where the mouse points.
  bool put(const PointerEvent& event);

 protected:
  bool grab(const PointerEvent& event) override;
  std::optional<Operation> begin() override { return std::nullopt; }
  void steer(const PointerEvent&) override {}
  void click(const PointerEvent& event) override { put(event); }
  void hover(const PointerEvent& event) override;

 private:
  std::optional<Operation> operation_at(const PointerEvent& event) const;
};

/// PUSH: the object follows the mouse on the plane of its contact.
class PushTool : public DragTool {
 public:
  using DragTool::DragTool;
  ToolKind kind() const override { return ToolKind::Push; }
  std::string hint() const override;

 protected:
  bool grab(const PointerEvent& event) override;
  std::optional<Operation> begin() override;
  void steer(const PointerEvent& event) override;

 private:
  Vec3 m_normal = Vec3::UnitZ();  // of the plane for following the mouse
  Vec3 m_start = Vec3::Zero();    // the object's position
};

/// PICK-UP: follows the mouse away from the support, or moves by a fixed distance.
class PickUpTool : public DragTool {
 public:
  using DragTool::DragTool;
  ToolKind kind() const override { return ToolKind::PickUp; }
  std::string hint() const override;
  /// Picks up the active object by ToolOptions::pick_up_distance.
  bool pick_up();

 protected:
  bool grab(const PointerEvent& event) override;
  std::optional<Operation> begin() override;
  void steer(const PointerEvent& event) override;
  void click(const PointerEvent&) override { pick_up(); }

 private:
  Vec3 m_direction = Vec3::UnitZ();
};

}  // namespace trivet::edit
