// Exact geometry of placed triangle meshes: first contact, interpenetration. Needs no other header.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "trivet/base.h"

TRIVET_BEGIN

/// Vertex ids, counter-clockwise seen from outside.
struct Triangle {
  std::int32_t a = 0, b = 0, c = 0;
  friend bool operator==(const Triangle&, const Triangle&) = default;
};

/// Triangles without any precondition: open or closed, with slivers and duplicates.
struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// Rule by which the mass of a mesh is found.
enum class MassRule {
  Volume,   // closed and oriented: the solid
  Surface,  // the faces, evenly
  Hull,     // the convex hull
};

/// A mesh with what queries need, made once. Copies share it. Thread-safe.
class TRIVET_API Shape {
 public:
  /// Vertices with equal coordinates become one.
  /// @throws Error (BadInput) for coordinates that are not finite and ids out of range.
  explicit Shape(const Mesh& mesh);

  [[nodiscard]] Mesh mesh() const;  // welded
  [[nodiscard]] std::size_t num_triangles() const;
  [[nodiscard]] Box box() const;
  [[nodiscard]] double volume() const;  // of the solid or the hull; 0 by MassRule::Surface
  [[nodiscard]] double area() const;    // of all faces
  [[nodiscard]] Vec3 centre_of_mass() const;
  [[nodiscard]] MassRule mass_rule() const;

  struct Internal;
  [[nodiscard]] const Internal& internal() const { return *m_internal; }
  explicit Shape(std::shared_ptr<const Internal> internal);

 private:
  std::shared_ptr<const Internal> m_internal;
};

/// A shape somewhere in the world.
struct PlacedShape {
  Shape shape;
  Pose pose;
  double scale = 1;  // metres per unit of the shape
};

/// Straight motion along `direction`, of any length but zero, by `distance` metres.
struct Translation {
  Vec3 direction;
  double distance = 0;
};

/// Right-handed turn about an axis of any length but zero through `centre`; any angle.
struct Turn {
  Vec3 axis;
  Vec3 centre;
  double angle_deg = 0;
};

struct FirstContact {
  bool crossing = false;  // the shapes cross before the motion begins; `amount` is 0 then
  double amount = 0;      // metres or degrees of the motion
  Vec3 point;             // on the fixed shape, world
  Vec3 normal;            // unit, from the fixed to the moving shape
  double gap = 0;         // metres between the two, there
};

/// Earliest contact of a moving shape with a fixed one; nullopt: the whole motion is free. Exact
/// for every pair of triangles, in closed form: nothing is stepped over, however thin.
/// @param clearance  metres at which the motion stops; 0: 2^-20 of the size of both together, or of
///   their largest coordinate.
/// @throws Error (BadInput) for a direction or an axis of length 0.
[[nodiscard]] TRIVET_API std::optional<FirstContact> first_contact(const PlacedShape& moving,
                                                                   const PlacedShape& fixed,
                                                                   const Translation& motion,
                                                                   double clearance = 0);
[[nodiscard]] TRIVET_API std::optional<FirstContact> first_contact(const PlacedShape& moving,
                                                                   const PlacedShape& fixed,
                                                                   const Turn& motion,
                                                                   double clearance = 0);
/// The same with the floor, the half space below z = 0.
[[nodiscard]] TRIVET_API std::optional<FirstContact> first_contact_with_floor(
    const PlacedShape& moving, const Translation& motion, double clearance = 0);

struct Interpenetration {
  std::int64_t crossing_pairs = 0;  // of faces with a point in common; touching counts
  int contained_parts = 0;          // components of one that lie inside the other
  [[nodiscard]] bool found() const { return crossing_pairs > 0 || contained_parts > 0; }
};

/// By exact predicates on the doubles of the placed vertices.
[[nodiscard]] TRIVET_API Interpenetration interpenetration(const PlacedShape& a,
                                                           const PlacedShape& b);

TRIVET_END
