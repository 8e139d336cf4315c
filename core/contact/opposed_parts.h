// Parts of two surfaces that cannot touch, as they do not face each other. Private.
#pragma once

#include <vector>

#include "core/contact/body.h"
#include "core/contact/contact.h"
#include "core/contact/recent_nodes.h"
#include "core/index/normal_cones.h"

namespace trivet {

/// A NormalCone in the world.
struct PlacedCone {
  Vec3 axis;
  double cos, sin;

  PlacedCone(const NormalCone& cone, const Mat3& world_from_object)
      : axis(world_from_object * Vec3(cone.axis[0], cone.axis[1], cone.axis[2])),
        cos(cone.cos),
        sin(cone.sin) {}
  PlacedCone(const Vec3& unit, double cosine, double sine) : axis(unit), cos(cosine), sin(sine) {}

  bool is_none() const { return cos > 1; }
};

/// Where a node or a face is, and where its features and faces may look.
struct PlacedPart {
  Vec3 centre;
  double radius;                          // of a sphere that holds it
  PlacedCone outwards, inwards, normals;  // see NormalCones
};

/// Tells parts of two bodies apart between which contact_points() finds nothing: the direction of
/// a contact is that between its places, and has to be in the cones of both of its features.
class OpposedParts {
 public:
  /// Makes the cones of both shapes. @param slack  as of contact_points().
  OpposedParts(const Body& a, const Body& b, double slack);

  /// False where the cones do not hold, see NormalCones.
  static bool hold(const Body& a, const Body& b, double slack);

  bool nodes_may_touch(Index node_a, Index node_b) {
    return may_touch(m_memory.nodes_a.get(m_search, node_a, m_a, node_a),
                     m_memory.nodes_b.get(m_search, node_b, m_b, node_b));
  }
  bool faces_may_touch(Index face_a, Index face_b) {
    return may_touch(m_memory.faces_a.get(m_search, face_a, m_a, face_a),
                     m_memory.faces_b.get(m_search, face_b, m_b, face_b));
  }

 private:
  struct Side {
    const Body& body;
    const NormalCones& cones;
    Mat3 turn;  // world_from_object without scale
    double scale;

    explicit Side(const Body& b);
  };
  struct NodePart : PlacedPart {
    NodePart(const Side& side, Index node);
  };
  struct FacePart : PlacedPart {
    FacePart(const Side& side, Index face);
  };
  struct Memory {
    RecentNodes<NodePart, 256> nodes_a, nodes_b;
    RecentNodes<FacePart, 256> faces_a, faces_b;
  };

  bool may_touch(const PlacedPart& a, const PlacedPart& b) const;

  Side m_a, m_b;
  double m_margin;  // metres by which places of a contact may lie outside of the parts
  Memory& m_memory;
  const std::uint64_t m_search = new_search();
};

/// As contact_points(), by all near faces, whether they face each other or not. For tests.
std::vector<ContactPoint> contact_points_of_all_faces(const Body& object, const Body& support,
                                                      double tolerance, double slack);

}  // namespace trivet
