// PUT, PUSH and PICK-UP with the mouse.
#pragma once

#include "apps/edit/tools/drag_tool.h"
#include "apps/edit/tools/hand_turn.h"

namespace trivet::edit {

/// PUT: previews the resting pose of the object in hand as a ghost; a click puts it there. In hand
/// is the active object until it is put or dropped; a click then takes another one.
class PutTool : public DragTool {
 public:
  PutTool(Document& document, const ToolOptions& options);
  ~PutTool() override;
  ToolKind kind() const override { return ToolKind::Put; }
  std::string hint() const override;
  std::string in_hand() const override;
  Cursor cursor() const override { return held() ? Cursor::Cross : Cursor::Arrow; }
  bool key(const KeyEvent& event) override;
  bool wants_key(const KeyEvent& event) const override;
  void cancel() override;

  /// Puts the active object where the mouse points, in hand or not.
  bool put(const PointerEvent& event);
  /// Takes the next object that is not placed yet. @return whether there is one.
  bool take_next();

 protected:
  bool grab(const PointerEvent& event) override;
  void steer(const PointerEvent&) override {}
  void click(const PointerEvent& event) override;
  void hover(const PointerEvent& event) override;
  bool wheel(const PointerEvent& event) override;

 private:
  const ObjectSnapshot* held() const;
  void drop();
  std::optional<Operation> operation_at(const PointerEvent& event);

  std::optional<ObjectId> m_dropped;  // the active object, if it is not in hand
  Document::Job m_job = 0;            // that puts the object in hand
  bool m_takes = false;               // the pressed button takes an object
  std::optional<PointerEvent> m_hovered;
  HandTurn m_turn;
  QMetaObject::Connection m_selected, m_finished;
};

/// PUSH: the object follows the mouse on the plane of its contact: what it lies on, a wall on which
/// it hangs, or the contact that the constraint window looks along.
class PushTool : public DragTool {
 public:
  using DragTool::DragTool;
  ToolKind kind() const override { return ToolKind::Push; }
  std::string hint() const override;

 protected:
  bool pulls_links(const PointerEvent&) const override { return true; }
  bool grab(const PointerEvent& event) override;
  std::optional<Operation> begin() override;
  void steer(const PointerEvent& event) override;
  TypedNumbers numbers() const override;
  void steer_by(const std::vector<double>& values) override;

 private:
  Vec2 snapped(const PointerEvent& event, const Vec2& goal);

  Vec3 m_normal = Vec3::UnitZ();  // of the plane for following the mouse
  Vec3 m_above = Vec3::UnitZ();   // PushOperation::normal
  Vec3 m_start = Vec3::Zero();    // the object's position, in the axes of the push
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
  TypedNumbers numbers() const override { return {{""}, 0, " m"}; }
  void steer_by(const std::vector<double>& values) override;
  void click(const PointerEvent&) override { pick_up(); }

 private:
  Vec3 m_direction = Vec3::UnitZ();
};

}  // namespace trivet::edit
