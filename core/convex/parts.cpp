#include "core/convex/parts.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/float32.h"
#include "core/base/tunables.h"
#include "core/convex/flat_thickness.h"
#include "core/mesh/hull.h"

namespace trivet {
namespace {

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(std::max<size_t>(points.size(), 1));
}

/// Thinner than this, of the size, a hull is flat but for the rounding of float32: programs that
/// make hulls of the same points refuse them.
constexpr double kThinnestHull = 2.5e-7;

bool is_flat(const std::vector<Vec3>& points) {
  const Vec3 centre = mean_of(points);
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& p : points) covariance += (p - centre) * (p - centre).transpose();
  // Eigenvectors are sorted, the direction of the least spread first.
  const Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvectors();
  const auto extent = [&](const Vec3& axis) {
    double low = kInfinity, high = -kInfinity;
    for (const Vec3& p : points) {
      low = std::min(low, axis.dot(p));
      high = std::max(high, axis.dot(p));
    }
    return high - low;
  };
  return extent(axes.col(0)) < std::max(kThinnestHull * extent(axes.col(2)),
                                        kFlatByRounding * farthest_coordinate(points));
}

/// Makes the hull a part, faces turned outwards. Returns whether the hull is solid.
bool hull_part(const std::vector<Vec3>& points, ConvexPart& part) {
  const ConvexHull hull = convex_hull(points);
  if (hull.vertices.empty() || is_flat(points)) return false;
  part = {};
  for (const Index v : hull.vertices) part.vertices.push_back(points[v]);
  // The hull's triangles come without a side: the mean of the corners is inside, and tells it.
  const Vec3 inside = mean_of(part.vertices);
  for (const Index3& t : hull.triangles) {
    Index3 face;
    // Corners are numbered anew within the part; the hull's list is sorted.
    for (int k = 0; k < 3; ++k)
      face[k] =
          static_cast<Index>(std::lower_bound(hull.vertices.begin(), hull.vertices.end(), t[k]) -
                             hull.vertices.begin());
    const Vec3& a = part.vertices[face[0]];
    const Vec3 normal = (part.vertices[face[1]] - a).cross(part.vertices[face[2]] - a);
    if (normal.dot(inside - a) > 0) std::swap(face[1], face[2]);
    part.triangles.push_back(face);
  }
  return true;
}

/// Points in a plane, on a line or in one place, copied to both sides along their flat directions.
std::vector<Vec3> thickened(const std::vector<Vec3>& points, double thickness) {
  const double half = flat_thickness(points, thickness) / 2;
  const Vec3 centre = mean_of(points);
  // The eigenvectors of the covariance are the directions in which the points lie flat, and those
  // in which they spread.
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& p : points) covariance += (p - centre) * (p - centre).transpose();
  const Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvectors();
  std::vector<Vec3> out = points;
  for (int k = 0; k < 3; ++k) {
    double extent = 0;
    for (const Vec3& p : points) extent = std::max(extent, std::abs((p - centre).dot(axes.col(k))));
    // A direction with extent needs no thickness.
    if (extent > half) continue;
    const std::vector<Vec3> before = out;
    out.clear();
    // Every point is doubled; two flat directions make four copies of each, three make eight.
    for (const Vec3& p : before)
      for (const double side : {-half, half}) out.push_back(as_float32(p + side * axes.col(k)));
  }
  return out;
}

std::vector<std::vector<Index>> faces_of_components(const Adjacency& adjacency) {
  std::vector<std::vector<Index>> out(adjacency.components.size());
  for (size_t f = 0; f < adjacency.face_component.size(); ++f)
    out[adjacency.face_component[f]].push_back(static_cast<Index>(f));
  return out;
}

class PartMaker {
 public:
  PartMaker(const Mesh& mesh, const Adjacency& adjacency) : m_mesh(mesh), m_adjacency(adjacency) {}

  void add_hull(std::span<const Vec3> points) {
    ConvexPart part;
    m_num_thickened += solid_hull(points, part);
    m_out.parts.push_back(std::move(part));
  }

  void add_component(size_t component, const std::vector<Index>& faces, bool decompose) {
    const std::vector<Vec3> points = corners_of(m_mesh, faces);
    add_hull(points);
    if (!decompose) return;
    // A component that nearly fills its hull is convex enough: its hull is the best part.
    const double hull = volume_of(m_out.parts.back());
    if (m_adjacency.components[component].balanced &&
        enclosed_volume(m_mesh, faces) >= (1 - kConvexEnough) * hull)
      return;
    std::vector<Index3> triangles;
    triangles.reserve(faces.size());
    for (const Index f : faces) triangles.push_back(m_mesh.triangles[f]);
    const std::vector<std::vector<Vec3>> pieces = decomposed(m_mesh.vertices, triangles);
    if (pieces.empty()) return;  // the hull stays
    m_out.parts.pop_back();
    for (const std::vector<Vec3>& piece : pieces) add_hull(piece);
  }

  ConvexParts take() {
    if (m_num_thickened > 0)
      m_out.notes.push_back(say("%1 flat parts get a thickness of %2 of their size",
                                m_num_thickened, std::to_string(kFlatPartThickness)));
    return std::move(m_out);
  }

 private:
  const Mesh& m_mesh;
  const Adjacency& m_adjacency;
  ConvexParts m_out;
  int m_num_thickened = 0;
};

/// Planes of a part, relative to a point inside: normal . x <= distance.
struct Planes {
  std::vector<Vec3> normals;
  std::vector<double> distances;

  Planes(const ConvexPart& part, const Vec3& inside) {
    // Degenerate triangles of the hull have no plane, and their neighbours bound the part.
    for (const Index3& t : part.triangles) {
      const Vec3 a = part.vertices[t[0]] - inside;
      const Vec3 normal = (part.vertices[t[1]] - part.vertices[t[0]])
                              .cross(part.vertices[t[2]] - part.vertices[t[0]]);
      if (!(normal.norm() > 0)) continue;
      normals.push_back(normal.normalized());
      distances.push_back(normals.back().dot(a));
    }
  }
  bool hold(const Vec3& p, double slack) const {
    for (size_t i = 0; i < normals.size(); ++i)
      if (normals[i].dot(p) > distances[i] + slack) return false;
    return true;
  }
};

}  // namespace

bool solid_hull(std::span<const Vec3> points, ConvexPart& part, double thickness) {
  // The hull is taken of positions rounded to float32, as files hold them, so that it is convex
  // there.
  std::vector<Vec3> rounded;
  for (const Vec3& p : points) rounded.push_back(as_float32(p));
  if (hull_part(rounded, part)) return false;
  if (!hull_part(thickened(rounded, thickness), part))
    throw Error(Error::Kind::BadInput, "a convex part is too small for a solid hull");
  return true;
}

ConvexParts convex_parts(const Mesh& mesh, const Adjacency& adjacency, PartRule rule) {
  PartMaker maker(mesh, adjacency);
  const size_t num_components = adjacency.components.size();
  // A model of very many components gets one hull, as a simulator could not take a hull for each.
  if (rule == PartRule::Hull || num_components == 0 || num_components > kMaxParts) {
    if (!mesh.vertices.empty()) maker.add_hull(mesh.vertices);
    ConvexParts out = maker.take();
    if (rule != PartRule::Hull && num_components > kMaxParts)
      out.notes.push_back(
          say("one hull for all of its %1 components, more than %2", num_components, kMaxParts));
    return out;
  }
  const std::vector<std::vector<Index>> faces = faces_of_components(adjacency);
  for (size_t c = 0; c < num_components; ++c)
    maker.add_component(c, faces[c], rule == PartRule::Decomposition);
  return maker.take();
}

// Shrinks in the dual: a plane becomes a point, a face of the hull of these points a vertex of the
// result.
ConvexPart shrunk(const ConvexPart& part, double clearance) {
  const Vec3 inside = mean_of(part.vertices);
  Planes planes(part, inside);
  // The part never shrinks by more than half the way to its nearest plane, so that it stays solid.
  const double nearest = *std::min_element(planes.distances.begin(), planes.distances.end());
  const double by = std::min(clearance, nearest / 2);
  if (!(by > 0)) return part;
  std::vector<Vec3> dual;
  // Each plane moves inwards; its dual point moves outwards.
  for (size_t i = 0; i < planes.normals.size(); ++i) {
    planes.distances[i] -= by;
    dual.push_back(planes.normals[i] / planes.distances[i]);
  }
  std::vector<Vec3> corners;
  // A face of the dual names three planes that meet in a corner of the result.
  for (const Index3& t : convex_hull(dual).triangles) {
    Mat3 rows;
    for (int k = 0; k < 3; ++k) rows.row(k) = dual[t[k]].transpose();
    const Vec3 corner = rows.fullPivLu().solve(Vec3::Ones());
    // Slivers of the dual have no reliable plane; their corner comes from their neighbours.
    if (corner.allFinite() && planes.hold(corner, by / 16))
      corners.push_back(as_float32(inside + corner));
  }
  ConvexPart out;
  return hull_part(corners, out) ? out : part;
}

double volume_of(const ConvexPart& part) {
  // The signed volumes of tetrahedra about a point inside add up to that of the part.
  const Vec3 inside = mean_of(part.vertices);
  double volume = 0;
  for (const Index3& t : part.triangles)
    volume += (part.vertices[t[0]] - inside)
                  .cross(part.vertices[t[1]] - inside)
                  .dot(part.vertices[t[2]] - inside) /
              6;
  return volume;
}

double enclosed_volume(const Mesh& mesh, std::span<const Index> faces) {
  double volume = 0;
  // A corner of the mesh is the origin, as coordinates far away would cost digits.
  const Vec3& origin = mesh.vertices[mesh.triangles[faces[0]][0]];
  for (const Index f : faces) {
    const Triangle t = mesh.triangle(f);
    volume += (t[0] - origin).cross(t[1] - origin).dot(t[2] - origin) / 6;
  }
  return std::abs(volume);
}

std::vector<Vec3> corners_of(const Mesh& mesh, std::span<const Index> faces) {
  std::vector<Index> ids;
  for (const Index f : faces)
    ids.insert(ids.end(), mesh.triangles[f].begin(), mesh.triangles[f].end());
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<Vec3> out;
  out.reserve(ids.size());
  for (const Index v : ids) out.push_back(mesh.vertices[v]);
  return out;
}

}  // namespace trivet
