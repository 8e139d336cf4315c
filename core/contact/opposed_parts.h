// Parts of two surfaces that cannot touch, as they do not face each other. Private.
#pragma once

#include <array>
#include <optional>
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

/// Cones in which vertices and edges of a part may look, on both sides of the surface; see
/// NormalCones.
struct PlacedSides {
  PlacedCone outwards, inwards;

  PlacedSides(const NormalCones::Part& part, const Mat3& world_from_object)
      : outwards(part.outwards, world_from_object), inwards(part.inwards, world_from_object) {}
};

/// A node or a face: its place, and the directions in which it may look.
struct PlacedPart {
  Vec3 centre;
  double radius;  // of a sphere that holds it
  PlacedSides features;
  PlacedCone normals;
};

/// Features of two faces that may be in contact with the other face.
struct FacingFeatures {
  struct OfFace {
    std::array<bool, 3> vertices{}, edges{};
  };
  OfFace a, b;
};

/// The features that belong to a face: each one of a mesh belongs to the first of its faces, so
/// that a pair of features is tried by one pair of faces. Each holds the place where they touch.
FacingFeatures::OfFace own_features(const Shape& shape, Index face);

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
  /// Features of their own; no value: nothing of the faces is in contact.
  std::optional<FacingFeatures> facing(Index face_a, Index face_b);

 private:
  struct Side {
    const Body& body;
    const NormalCones& cones;
    Mat3 turn;  // world_from_object without scale
    double scale;

    explicit Side(const Body& b);
    std::array<PlacedSides, 3> features(const std::vector<NormalCones::Part>& all,
                                        const Index3& ids, const std::array<bool, 3>& own) const;
  };
  struct NodePart : PlacedPart {
    NodePart(const Side& side, Index node);
  };
  struct FacePart : PlacedPart {
    FacingFeatures::OfFace own;
    std::array<PlacedSides, 3> vertices, edges;  // its own

    FacePart(const Side& side, Index face);
  };
  struct Memory {
    RecentNodes<NodePart, 256> nodes_a, nodes_b;
    RecentNodes<FacePart, 256> faces_a, faces_b;
  };

  PlacedCone ways_to(const PlacedPart& a, const PlacedPart& b) const;
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
