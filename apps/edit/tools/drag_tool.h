// Base of all dragging tools: press, pull, release; Escape cancels. Numbers that are typed
// meanwhile take the place of the mouse; Return ends the drag there.
#pragma once

#include "apps/edit/tools/joint_pull.h"
#include "apps/edit/tools/operation_of.h"
#include "apps/edit/tools/picking.h"
#include "apps/edit/tools/tool.h"
#include "apps/edit/tools/typed_numbers.h"

namespace trivet::edit {

class DragTool : public Tool {
 public:
  DragTool(Document& document, const ToolOptions& options)
      : m_document(document), m_options(options) {}

  bool pointer(const PointerEvent& event) final;
  bool key(const KeyEvent& event) override;
  void cancel() override;
  bool is_active() const override { return m_pressed.has_value(); }
  Overlay overlay(const View& view) const override;
  Cursor cursor() const override;
  bool wants_key(const KeyEvent& event) const override;
  std::string reading() const override;

 protected:
  /// Handles a press of the left button. @return whether it starts a drag or click.
  virtual bool grab(const PointerEvent& event) = 0;
  /// The operation to start; nullopt: none.
  virtual std::optional<Operation> begin() { return std::nullopt; }
  /// Starts the drag: of begin(), unless a tool has its own. @return whether there is one.
  virtual bool start(const PointerEvent& event);
  virtual bool follows() const { return m_document.is_dragging(); }
  virtual void end() { m_document.end_drag(); }
  virtual void give_back() { m_document.cancel_drag(); }
  /// True if a press there pulls drawers, doors and lids in their joints.
  virtual bool pulls_links(const PointerEvent&) const { return false; }
  /// The link that a press there would pull; null: none.
  const ObjectSnapshot* link_at(const PointerEvent& event) const;
  bool is_pulling() const { return m_pull.has_value(); }
  /// True if presses wait for the running job.
  virtual bool waits() const { return m_document.is_busy(); }
  /// Updates the goal from the mouse.
  virtual void steer(const PointerEvent& event) = 0;
  /// Numbers that can be typed during this drag.
  virtual TypedNumbers numbers() const { return {}; }
  /// Updates the goal from typed numbers. @param values  one per axis of numbers().
  virtual void steer_by(const std::vector<double>&) {}
  virtual void click(const PointerEvent&) {}
  virtual void hover(const PointerEvent&) {}
  /// @return whether the wheel is the tool's now.
  virtual bool wheel(const PointerEvent&) { return false; }

  const SceneSnapshot& scene() const { return *m_document.snapshot(); }
  /// Handles a press that has grabbed the active object: drags snap what is grabbed of it, one of
  /// its corners or edges where they are near.
  void grab_for_snapping(const PointerEvent& event);
  /// True if this drag snaps: the option, turned over by Control.
  bool snaps(const PointerEvent& event) const {
    return m_options.snap.on != event.modifiers.control;
  }
  /// The displacement that takes what is grabbed to where the mouse snaps; nullopt: it does not, or
  /// only to a grid.
  std::optional<Vec3> snapped_way(const PointerEvent& event);
  /// A coordinate of what is grabbed, moved by `way`, on the grid. @return the way there.
  double on_grid_from(double grabbed, double way) const;
  /// Moves a place to the corner or edge, or to the point of the grid, that the mouse means.
  /// @param moving  objects that are no targets.
  void snap_place(const PointerEvent& event, const std::vector<ObjectId>& moving, Picked& place);
  void show_snap(const Snap& snap);
  void forget_snap();
  void note_grid() { m_note = grid_in_words(m_options.snap.grid_step); }
  /// Degrees of a step, 0: none; says so at the pointer.
  double angle_step(const PointerEvent& event);
  /// Grabbed point: world.
  const Vec3& grabbed() const { return m_base; }
  /// Makes the object under the mouse active; if it is selected, the selection stays.
  const ObjectSnapshot* grab_object(const PointerEvent& event);
  const ObjectSnapshot* active() const;
  template <class T>
  T operation_of(const Object& object) const {
    return edit::operation_of<T>(object, m_document, m_options);
  }

  Document& m_document;
  const ToolOptions& m_options;
  std::optional<PointerEvent> m_pressed;
  Vec3 m_grabbed_at = Vec3::Zero();  // world, pressed point
  bool m_is_drag = false;

 private:
  bool begin_pull();
  void steer_pull(const PointerEvent& event);
  bool type(const KeyEvent& event);
  void finish_drag();

  Vec3 m_base = Vec3::Zero();    // world: what is grabbed
  std::optional<Vec3> m_target;  // where it snaps to
  std::string m_note;            // the same in words
  TypedNumbers m_typed;
  std::optional<JointPull> m_pull;
};

}  // namespace trivet::edit
