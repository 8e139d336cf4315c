// Friction by anchors: each vertex in contact is tied to a point by an elastic-plastic spring, so
// that what holds does not creep.
#pragma once

#include "core/flex/contact.h"

namespace trivet::flex {

/// Force of an obstacle on a vertex, N.
struct Borne {
  double up = 0, size = 0;  // the vertical part; sum of all magnitudes
};

/// Forces of contact at the vertices, and by whom.
struct NodalForces {
  Points outside, own;                 // N, of obstacles and of the body itself
  std::vector<double> outside_cap;     // N: the largest friction there
  std::vector<std::vector<Borne>> by;  // [vertex][owner]
};
NodalForces nodal_forces(const Surroundings& surroundings, const std::vector<ContactPair>& pairs,
                         bool with_owners = false);

/// A vertex tied to a point of the world, or, against the body itself, of one of its faces.
/// Normal, cap and anchor are fixed until the next update.
struct Anchor {
  bool is_on = false;
  Vec3 point = Vec3::Zero();  // world; of its own: offset from the point of the face
  Vec3 normal = Vec3::UnitZ();
  double cap = 0;  // N, largest force
  int face = -1;   // of its own: the other layer's
  Vec3 weights = Vec3::Zero();
};

class Friction {
 public:
  /// @param slip  metres of elastic way until the largest force.
  Friction(const Body& body, double slip);

  /// Takes normals and caps of the contact as it is. Forces are kept, not slips: a change of the
  /// normal force alone changes no friction within its cone.
  /// @param keep_faces  near rest, where the nearest face may flip.
  void update(const Points& x, const std::vector<ContactPair>& pairs, const NodalForces& forces,
              bool keep_faces);
  double energy(const Points& x, Total& total) const;
  /// Friction on each vertex by obstacles, N.
  Vec3 force(const Points& x, size_t vertex) const;
  /// Largest share of a cap in use, of vertices that bear more than `least` newtons.
  double largest_use(const Points& x, const NodalForces& forces, double least) const;
  double slip() const { return m_slip; }

 private:
  Vec3 slipped(const Points& x, size_t vertex, const Anchor& anchor) const;
  Vec3 kept_slip(const Points& x, size_t vertex, const Anchor& anchor, const Vec3& normal,
                 double cap) const;
  void update_outside(const Points& x, const NodalForces& forces);
  void update_own(const Points& x, const std::vector<ContactPair>& pairs, const NodalForces& forces,
                  bool keep_faces);
  double add(const Points& x, size_t vertex, const Anchor& anchor, Total& total) const;

  const Body& m_body;
  double m_slip, m_least;  // N: forces below it have no friction
  std::vector<Anchor> m_outside, m_own;
};

}  // namespace trivet::flex
