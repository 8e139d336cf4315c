// What moves as one rigid body, among the others, which stand still.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/contact/first_contact.h"
#include "ops/rest.h"
#include "ops/settle/settle.h"
#include "ops/verify.h"

namespace trivet {

/// The object, what lies on it, transitively [Shinya 1995, 4.2], and the objects of their groups
/// with what lies on those. The object first, the others by slot. Fixed objects are never carried.
/// @param together  in the scene, as those of the object's group.
std::vector<ObjectId> carried_with(const Scene& scene, ObjectId object,
                                   std::span<const ObjectId> together = {});

/// What a hand moves: the object, those `together` with it, and their groups. The rest of
/// carried_with() only lies on these.
std::vector<ObjectId> led_with(const Scene& scene, ObjectId object,
                               std::span<const ObjectId> together = {});

/// Why these may not be moved by an operation: fixed or locked. Empty: they may.
std::string why_not_movable(const Scene& scene, std::span<const ObjectId> ids);

/// A contact point of a member with something outside the group.
struct Touch {
  Index member = 0;
  Index outside = ContactsWith::kFloor;  // index of outside()
  ContactPoint point;
};

/// An object and its loads on their way. Works on copies: the scene changes only by commit_group().
class MovingGroup {
 public:
  /// @param clearance  metres, > 0.
  MovingGroup(const Scene& scene, ObjectId object, std::span<const ObjectId> together,
              double clearance, const SettleOptions& options);

  const Scene& scene() const { return *m_scene; }
  const std::vector<ObjectId>& ids() const { return m_ids; }  // the object first
  const Object& object() const { return m_scene->at(m_ids[0]); }
  const std::vector<ObjectId>& led() const { return m_led; }  // see led_with()
  const Surroundings& outside() const { return m_outside; }
  double clearance() const { return m_clearance; }
  std::span<const Body> bodies() const { return m_bodies; }
  const Pose& pose(Index member = 0) const { return m_poses[member]; }
  std::vector<Placement> placements() const;
  Aabb box() const;
  /// Of mass, of the object.
  Vec3 centre() const;
  double size() const;  // metres, diagonal of the object

  /// Moves all so that the object has this pose.
  void place(const Pose& pose);
  void advance(const Motion& motion, double time);
  /// First contact with what is outside, from where the group is. Costs what is near the way.
  FirstContact first_contact(const Motion& motion);
  /// What a member touches outside, within kContactTolerance clearances; kept until it moves.
  const std::vector<ContactsWith>& contacts(Index member) const;
  std::vector<Touch> touches() const;
  /// Opens gaps a little, so that the group can slide along what it touches; see kSlideGap. Between
  /// contacts that face each other there may be no room for that: the group goes to the middle, and
  /// motions keep a part of the clearance only, until the next float_off().
  /// @return whether it has moved.
  bool float_off(const std::vector<Touch>& touches);
  /// Settles from where the group is; the group then is where it ended.
  SettleOutcome settle(Interrupt* interrupt);

  /// Where everything is, to come back to.
  struct Place {
    std::vector<Pose> origins;
    Vec3 offset;
  };
  Place here() const { return {m_origins, m_offset}; }
  void go_back(const Place& place);
  /// Whether anything is elsewhere than in the scene.
  bool has_moved() const;

  std::int64_t num_queries() const { return m_num_queries; }
  std::int64_t num_face_pairs() const { return m_num_face_pairs; }

 private:
  void update();
  std::optional<Vec3> lift_for_sliding(const std::vector<ContactPoint>& points, double part) const;

  const Scene* m_scene;
  std::vector<ObjectId> m_ids, m_led;
  Surroundings m_outside;
  double m_clearance, m_motion_clearance;
  SettleOptions m_options;
  // Translations are summed up before they are added: members shift among each other by no more
  // than one rounding, however long the way.
  std::vector<Pose> m_origins;
  Vec3 m_offset = Vec3::Zero();
  std::vector<Pose> m_poses;
  std::vector<Body> m_bodies;
  mutable std::vector<std::optional<std::vector<ContactsWith>>> m_contacts;  // those asked for
  std::int64_t m_num_queries = 0, m_num_face_pairs = 0;
};

}  // namespace trivet
