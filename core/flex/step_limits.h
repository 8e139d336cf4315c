// Limits of a step that make crossings impossible: half-spaces of each vertex, without a look at
// times of contact.
#pragma once

#include "core/flex/contact.h"

namespace trivet::flex {

/// A vertex's step s keeps to normal . s >= -room.
struct HalfSpace {
  int vertex;
  Vec3 normal;
  double room;  // metres, >= 0
};

/// For each pair that the wanted step could bring together there is a plane between its elements
/// through their closest points; each side keeps a tenth of its distance from it. Convex elements
/// on two sides of a plane at all times of a straight motion do not meet, and stay their offset
/// apart. Pairs without a plane cannot meet, since each vertex ends inside the box that was
/// searched. A shorter step along the same line is as safe. Sliding along a contact is not
/// shortened. Vertices are limited in shares, by several threads; the half-spaces of a share are
/// gone after it, as long steps have more than the equations have entries.   @see [Divide and
/// Truncate, Newton Physics 2026]
class StepLimits {
 public:
  StepLimits(const Surroundings& surroundings, Contact& contact);

  /// Shortens and turns the step of each vertex. @return for each vertex that was turned by more
  /// than a tenth of the layer, one half-space, at whose border its step ends. One for each plane
  /// would hold it along the planes, too, where they are many.
  std::vector<HalfSpace> limit(const Points& x, Points& step);

 private:
  struct Share;  // some of the vertices
  const std::vector<NearPair>* find_near(const Points& x, const Points& step);
  std::vector<Share> shares(const std::vector<NearPair>& near, int num_vertices) const;
  void limit_share(const Points& x, const std::vector<NearPair>& near, Share& share,
                   Points& step) const;
  void add_pair(const Points& x, const NearPair& pair, Share& share) const;
  void add(int vertex, const Vec3& normal, double distance, Share& share) const;

  const Surroundings& m_surroundings;
  Contact& m_contact;
  std::vector<Aabb> m_room;  // in which each vertex's step may end
  std::vector<double> m_length;
};

}  // namespace trivet::flex
