// Objects that move as one rigid body among the others, which do not move.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ops/base/context.h"
#include "ops/operations/carried_with.h"
#include "ops/settle/settle.h"

namespace trivet {

/// A contact point of a member with an object outside the group or the floor.
struct GroupContact {
  Index member = 0;
  Support with;
  ContactPoint point;
};

/// An object and its loads on their way. Works on copies: the scene does not change.
class MovingGroup {
 public:
  /// @param clearance  metres, > 0. @param detector  null: BVHs.
  /// @param more_loads  as carried_with() has them.
  MovingGroup(const Scene& scene, ObjectId object, std::span<const ObjectId> together,
              double clearance, const SettleOptions& options, Detector* detector,
              std::span<const ObjectId> more_loads = {});

  const Scene& scene() const { return *m_scene; }
  const std::vector<ObjectId>& ids() const { return m_ids; }  // the object first
  const Object& object() const { return m_scene->at(m_ids[0]); }
  const std::vector<ObjectId>& driven() const { return m_driven; }  // see driven_with()
  const Neighbourhood& outside() const { return m_outside; }
  double clearance() const { return m_clearance; }
  std::span<const Body> bodies() const { return m_bodies; }
  const Pose& pose(Index member = 0) const { return m_poses[member]; }
  std::vector<Placement> placements() const;
  Aabb box() const;
  /// Centre of mass of the object.
  Vec3 centre() const;
  double size() const { return size_of(object()); }

  /// Moves all so that the object has this pose.
  void place(const Pose& pose);
  void advance(const Motion& motion, double time);
  /// Gives a member a pose that differs from the one it has by rounding alone.
  void correct(Index member, const Pose& pose);
  /// First contact with the outside, from where the group is.
  ObstacleContact first_contact(const Motion& motion);
  /// Contacts of a member with the outside, within kContactTolerance clearances; cached until the
  /// group moves.
  const std::vector<ContactsWith>& contacts(Index member) const;
  std::vector<GroupContact> group_contacts() const;
  /// Opens gaps a little, so that the group can slide along its contacts; see kSlideGap. Between
  /// contacts that oppose each other there may be no room for that: the group goes to the middle,
  /// and motions keep a part of the clearance only, until the next separate().
  /// @return whether it has moved.
  bool separate(const std::vector<GroupContact>& group_contacts);
  /// Settles from where the group is; the group then is where it ended.
  SettleOutcome settle(Interrupt* interrupt);
  /// As a rigid body of which all members weigh, with finite friction: one motion of a group, up to
  /// `longest_turn`; an object without loads settles. See SettleProblem.
  SettleOutcome give_way(Interrupt* interrupt, double longest_turn, std::int64_t max_queries);

  /// Poses of all members, to come back to.
  struct Place {
    std::vector<Pose> origins;
    Vec3 offset;
  };
  Place here() const { return {m_origins, m_offset}; }
  void go_back(const Place& place);
  /// True if any member is elsewhere than in the scene.
  bool has_moved() const;

  std::int64_t num_queries() const { return m_num_queries; }
  std::int64_t num_face_pairs() const { return m_num_face_pairs; }

 private:
  void update();
  ObstacleContact first_contact(std::span<const Body> bodies, const Neighbourhood& others,
                                const Motion& motion);
  SettleOutcome settle(SettleProblem problem, bool loads_weigh);
  std::optional<Vec3> separating_motion_for_sliding(const std::vector<ContactPoint>& points,
                                                    double part) const;

  const Scene* m_scene;
  std::vector<ObjectId> m_ids, m_driven;
  Neighbourhood m_outside;
  std::vector<Neighbourhood> m_outside_of;  // of each member, if rules may part them; else empty
  double m_clearance, m_motion_clearance;
  SettleOptions m_options;
  Detector* m_detector;
  // Translations are summed up before they are added: members shift among each other by no more
  // than one rounding, however long the way.
  std::vector<Pose> m_origins;
  Vec3 m_offset = Vec3::Zero();
  std::vector<Pose> m_poses;
  std::vector<Body> m_bodies;
  mutable std::vector<std::optional<std::vector<ContactsWith>>> m_contacts;  // computed so far
  std::int64_t m_num_queries = 0, m_num_face_pairs = 0;
};

}  // namespace trivet
