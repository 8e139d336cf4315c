// Private. Faces of a convex hull, and those that count as one facet.
#pragma once

#include <array>
#include <vector>

#include "core/base/types.h"

namespace trivet {

inline constexpr double kHullTolerance = 1e-9;  // of the object's size
/// Cosine of 0.5 degrees, within which normals of one facet are: scans and polygonised cylinders
/// are never quite flat.
inline constexpr double kFacetMergeCosine = 0.99996192306417129;

struct HullFace {
  Index3 corners;
  Vec3 normal = Vec3::Zero();  // unit, outwards
  double area = 0;
  Index region = -1;
  std::array<Index, 3> across = {-1, -1, -1};  // face beyond the edge from corner k to k + 1
};

class HullFacets {
 public:
  explicit HullFacets(std::vector<Vec3> points);

  const std::vector<Vec3>& points() const { return m_points; }
  double size() const { return m_size; }  // diagonal of the points' box
  /// In the order of their corners; none: the points are in one plane.
  const std::vector<HullFace>& faces() const { return m_faces; }
  /// Faces whose normals are within kFacetMergeCosine of the largest one's, from the largest face
  /// on; what is thinner than rounding joins whatever is beside it. A face's region is its facet.
  const std::vector<std::vector<Index>>& facets() const { return m_facets; }
  Vec3 corner(const HullFace& face, int k) const { return m_points[face.corners[k]]; }

 private:
  void make_faces();
  void connect();
  void grow_facets();
  bool joins(const HullFace& face, const HullFace& seed) const;

  std::vector<Vec3> m_points;
  double m_size = 0;
  std::vector<HullFace> m_faces;
  std::vector<std::vector<Index>> m_facets;
};

}  // namespace trivet
