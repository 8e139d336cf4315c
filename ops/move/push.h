// PUSH/PULL [Shinya 1995, 4.1, Fig. 4]: along the surface on which the object lies.
//
// Seen from above the object goes straight on; its height follows the contacts, which it keeps. The
// loop goes from event to event: a first contact ahead, or the end of the last contact that
// carries. Then it is decided, as in the paper:
//   a wall ahead        climbed if it is no higher than step_up (Fig. 4c); else slid along, or the
//                       object stays where it collided (Fig. 4b)
//   no contact any more dropped if it is no deeper than step_down (Fig. 4d); else it stays where
//                       the contact ends (Fig. 4e)
// Departs from the paper, which goes by small steps of fixed length and corrects each afterwards:
// no obstacle and no gap is too small to be seen. Surfaces steeper than 60 degrees count as steps.
// When the object is let go at the end (PushOperation::settle) and would sink deeper than
// step_down, it is pulled back to the last place on its way from where it does not.
#pragma once

#include <optional>

#include "ops/move/attempt.h"
#include "ops/move/slide_plan.h"

namespace trivet {

/// A push that goes on and on: for editors that drag. Nothing is committed here.
class Push {
 public:
  /// Refuses when nothing carries the object.
  /// @param attempt  not refused. @param o  its thresholds; direction and distance do not matter.
  Push(Attempt& attempt, const PushOperation& o);

  /// Pushes until the object's position is at `goal`, seen from above, or stopped; attempt.result()
  /// says why.
  void push_to(const Vec2& goal);
  /// Lets the object go, from the last place on the way where it does not sink deeper than
  /// step_down; if there is none, from where it is.
  void let_go();
  /// Lets it go if that is asked for, and commits.
  OperationResult finish();

 private:
  using Place = MovingGroup::Place;
  /// What was found to be in the way, for as long as the contacts do not show it.
  struct Obstacle {
    Vec3 normal, point;
    Index outside;
  };
  /// A steep rise or drop that is being followed.
  struct Steep {
    Place start;
    double z;
    size_t way_length;  // of m_way
  };
  /// A place on the way: how far everything is from where it was at the start.
  struct WayPoint {
    Vec3 offset;
    bool straight;  // from the one before
  };
  enum class Next { GoOn, Stop };

  void look_around();
  void note_way(bool straight);
  std::optional<SettleOutcome> settled_from(const Vec3& offset);
  bool holds_at(const Vec3& offset);
  std::optional<Vec3> last_place_that_holds();
  Vec2 way_left() const;
  SlidePlan plan(const Vec3& direction) const;
  double end_of(size_t contact, const Vec3& velocity) const;
  Next event();
  Next pass_wall(const SlidePlan& blocked, const Vec3& direction, double length);
  Next go(const SlidePlan& plan, double length);
  std::optional<double> steep_allowance(const SlidePlan& plan);
  Next give_up_steep(const SlidePlan& plan);
  std::optional<double> step_up(const Vec3& direction, const Vec3& wall, double highest);
  bool step_down(const Vec3& direction);
  Next stop(OperationResult::End end);
  Next stop_blocked(size_t contact);

  Attempt& m_attempt;
  MovingGroup& m_group;
  const PushOperation& m_options;
  double m_shortest;  // metres, a few clearances: shorter ways are none
  Vec2 m_goal = Vec2::Zero();
  std::vector<Touch> m_touches;
  std::optional<Vec3> m_seen_at;  // the offset at which m_touches were found
  std::vector<Vec3> m_normals;    // of the touches, then of the obstacles
  std::vector<Obstacle> m_obstacles;
  std::optional<Steep> m_steep;
  bool m_climb = true;  // steep surfaces may be tried
  int m_num_stalls = 0;
  bool m_floats = false;  // gaps were opened here
  std::vector<WayPoint> m_way;
};

}  // namespace trivet
