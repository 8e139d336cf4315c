// States of a PUSH/PULL [Shinya 1995, 4.1, Fig. 4]: along the surface on which the object lies.
//
// Seen from above the object goes straight on; its height follows the contacts, which it keeps. The
// loop goes from event to event, and each event is one row of this table:
//
//   state                          event                      next
//   at the goal                    -                          stop: Reached
//   contacts allow the direction   first contact ahead        note the obstacle, plan again
//                                  a carrying contact ends    plan again
//                                  steep rise or drop longer  back to where it began; from there it
//                                  than a step may be         is a wall, or stop: Edge
//   a wall is in the way           a step it may climb        climb it (Fig. 4c)
//                                  higher, slide is on        along it
//                                  else                       stop: Blocked or Step (Fig. 4b)
//   no contact carries             a step it may go down      drop onto it (Fig. 4d)
//                                  deeper                     stop: Edge (Fig. 4e)
//   kMaxStalls events, no way      -                          stop: Blocked
//
// Departs from the paper, which goes by small steps of fixed length and corrects each afterwards:
// no obstacle and no gap is too small to be seen. Surfaces steeper than 60 degrees count as steps.
// Above is along PushOperation::normal: up for what lies, away from the wall for what hangs on it.
// All thresholds are along it, and directions are in the plane across it; see push_axes.h.
//
// When the object is released at the end (PushOperation::settle) and would sink deeper than
// a step, it is pulled back to the last place on its way from which it does not; along other
// surfaces it is just released.
#pragma once

#include <optional>

#include "ops/operations/move_plan.h"
#include "ops/operations/push.h"
#include "ops/operations/slide_plan.h"

namespace trivet {

/// A resumable push, for interactive drags, too. Nothing is committed here.
///
/// Invariants between events: the group is free of collision; m_way ends where it is; m_normals are
/// those of m_group_contacts, then of m_obstacles, in this order, as contacts are numbered by
/// SlidePlan; m_obstacles are what stopped the last motion and is not among m_group_contacts;
/// m_steep is set while a steep surface is followed.
class Push {
 public:
  /// Refuses when nothing carries the object.
  /// @param planner  not refused; outlives this. @param o  its thresholds; direction and distance
  ///   are ignored.
  Push(MovePlanner& planner, const PushOperation& o);

  /// Pushes until the object's position is at `goal`, seen from above, or stopped; see
  /// planner.result().
  void push_to(const Vec2& goal);
  /// Releases the object if that is asked for, and verifies where it is.
  MovePlan finish();

 private:
  using Place = MovingGroup::Place;
  /// Stopped the last motion; kept for as long as the contacts do not show it.
  struct Obstacle {
    Vec3 normal, point;  // world
    Support with;
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
  static constexpr int kMaxStalls = 12;  // events in a row without a way

  // From the axes of the push to those of the world, and back.
  Vec3 to_world(const Vec3& v) const { return m_is_level ? v : Vec3(m_axes.transpose() * v); }
  Vec3 from_world(const Vec3& v) const { return m_is_level ? v : Vec3(m_axes * v); }
  Vec3 position() const { return from_world(m_group.pose().translation); }
  bool carries(const ContactPoint& p) const;
  bool is_known_to_lie() const;
  void find_contacts();
  void note_way(bool straight);
  std::optional<SettleOutcome> settled_from(const Vec3& offset);
  bool holds_at(const Vec3& offset);
  std::optional<Vec3> last_place_that_holds();
  void release();
  Vec2 way_left() const;
  SlidePlan slide(const Vec3& direction) const;
  double end_of(size_t contact, const Vec3& velocity) const;
  Next event();
  Next pass_wall(const SlidePlan& blocked, const Vec3& direction, double length);
  Next go(const SlidePlan& plan, double length);
  std::optional<double> steep_allowance(const SlidePlan& plan);
  Next give_up_steep(const SlidePlan& plan);
  std::optional<double> climb(const Vec3& direction, const Vec3& wall, double highest);
  bool go_down(const Vec3& direction);
  Next stop(OperationResult::End end);
  Next stop_blocked(size_t contact);

  MovePlanner& m_planner;
  MovingGroup& m_group;
  const PushOperation& m_options;
  bool m_is_level;
  Mat3 m_axes;        // rows: two in the plane, the normal
  double m_shortest;  // metres, a few clearances: shorter ways are none
  Vec2 m_goal = Vec2::Zero();
  std::vector<GroupContact> m_group_contacts;
  std::optional<Vec3> m_found_at;  // the offset at which m_group_contacts were found
  std::vector<Vec3> m_normals;     // of the touches, then of the obstacles; axes of the push
  std::vector<Obstacle> m_obstacles;
  std::optional<Steep> m_steep;
  bool m_climb = true;  // steep surfaces may be tried
  int m_num_stalls = 0;
  bool m_is_separated = false;  // gaps were opened here
  std::vector<WayPoint> m_way;
};

}  // namespace trivet
