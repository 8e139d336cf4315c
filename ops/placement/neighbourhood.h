// Broad phase of every query: the other objects near a place, from the scene's tree.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/contact/first_contact.h"
#include "core/scene/scene.h"

namespace trivet {

class Detector;

/// Placed objects as bodies, in the order of the scene.
struct Neighbours {
  std::vector<ObjectId> ids;
  std::vector<Body> bodies;
};

/// An object and its pose, which need not be the one in the scene.
struct Placement {
  ObjectId id;
  Pose pose;
};

Body body_of(const Object& object, const Pose& pose);
/// In its pose in the scene.
Body body_of(const Object& object);
/// Diagonal of the object's own box, metres.
double size_of(const Object& object);

/// All placed objects of a scene but some, and its floor. What a rule lets all that is left out
/// pass through is no neighbour. Refers to the scene.
class Neighbourhood {
 public:
  Neighbourhood(const Scene& scene, std::span<const ObjectId> without);
  Neighbourhood(const Scene& scene, ObjectId without);

  /// Excludes these, too; the floor as well if it is among them.
  void leave_out(std::span<const Support> left_out);

  const Scene& scene() const { return *m_scene; }
  bool floor() const { return m_floor; }
  /// Objects whose world boxes overlap `box` grown by `margin` metres. Cost O(log n + found).
  Neighbours near(const Aabb& box, double margin) const;
  /// Ids alone.
  std::vector<ObjectId> ids_near(const Aabb& box, double margin) const;
  /// World box of all of them.
  Aabb box() const;
  bool excludes(ObjectId id) const;

 private:
  bool may_be_passed(PairKind kind) const;

  const Scene* m_scene;
  std::vector<ObjectId> m_without;  // sorted by slot
  std::vector<PairKind> m_passing;  // kinds of those left out at first; empty: no rules
  bool m_floor;
};

/// First contact with a neighbourhood. On Free, `with` and all fields but the status are
/// meaningless; FirstContact::fixed always is.
struct ObstacleContact : FirstContact {
  Support with;
};

/// First contact of bodies that move as one. Only neighbours in the box that the motion sweeps are
/// looked at.
/// @param detector  null: BVHs; the answer does not depend on it. @param planes  see
///   FirstContactQuery.
ObstacleContact first_contact(std::span<const Body> moving, const Neighbourhood& others,
                              const Motion& motion, const Clearance& clearance, Detector* detector,
                              SeparatingPlanes* planes = nullptr);
/// The same for many motions from here, asked together and early: see
/// Detector::first_contacts_early().
std::vector<ObstacleContact> first_contacts_early(std::span<const Body> moving,
                                                  const Neighbourhood& others,
                                                  std::span<const Motion> motions,
                                                  const Clearance& clearance, Detector& detector,
                                                  SeparatingPlanes* planes);

}  // namespace trivet
