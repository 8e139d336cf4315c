// One gesture that moves an object: it slides on what carries it, and is put where the mouse points
// beyond. Start with SelectTool, which makes one of each drag.
//
//   the foot, where the object stands seen from the mouse, is
//     over the level that carries it, or a wall there  slides: a PUSH that hangs back when blocked
//     over another surface, beside a wall on it, or
//     far beyond what blocks                           a PUT there, shown by the ghost
//   turned, lifted, or without a support               a PUT, as above
#pragma once

#include "apps/edit/tools/hand_turn.h"
#include "apps/edit/tools/operation_of.h"
#include "apps/edit/tools/picking.h"

namespace trivet::edit {

class HandGesture {
 public:
  HandGesture(Document& document, const ToolOptions& options);
  ~HandGesture();

  /// Takes the active object. @param grabbed_px  pixel at which it is held.
  void begin(const View& view, const Vec2& grabbed_px);
  bool is_on() const { return m_object.has_value(); }
  /// Pixel of the foot for a mouse there.
  Vec2 foot_px(const Vec2& px) const { return px + m_foot_offset; }
  /// The surface under the foot; nullopt: there is none.
  std::optional<Picked> under_foot(const PointerEvent& event);
  const std::vector<ObjectId>& moving() const { return m_moving; }

  /// @param at  under_foot(), snapped. With Shift the mouse lifts.
  void follow(const PointerEvent& event, const std::optional<Picked>& at);
  HandTurn& turning() { return m_turn; }
  /// Commits as one step; nothing where nothing moves.
  void release();
  void cancel();

 private:
  const ObjectSnapshot* object() const;
  bool is_level_support(const Picked& at) const;
  bool slides() const;
  bool hangs_far_back() const;
  bool is_back() const;
  bool let_go();
  bool hangs_back_from_all() const;
  bool falls_from_edge() const;
  std::optional<Picked> beside(const Picked& wall) const;
  const Picked& put_at() const;
  void update();
  void show_rest_of_slide();
  PutOperation put_in_hand() const;
  std::vector<Operation> choices() const;
  void end();

  Document& m_document;
  const ToolOptions& m_options;
  HandTurn m_turn;
  std::optional<ObjectId> m_object;
  std::shared_ptr<const Object> m_start;  // as it was
  std::vector<ObjectId> m_moving;         // and what is hidden
  Vec3 m_foot = Vec3::Zero();             // world, at the start
  double m_size = 0;                      // metres
  bool m_several = false;                 // moves with others of the selection: it only slides
  Vec2 m_foot_offset = Vec2::Zero();      // pixels
  std::optional<ObjectId> m_in_front;     // hides the foot at the start
  Vec2 m_last_px = Vec2::Zero();
  Picked m_at;
  std::optional<Picked> m_beside;  // on the level where it slides, if m_at is behind a wall
  double m_lift = 0, m_px = 0;     // metres; of a pixel
  bool m_pushes = false, m_slides = false;
  QMetaObject::Connection m_snapshot, m_ended;
};

}  // namespace trivet::edit
