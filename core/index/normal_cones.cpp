#include "core/index/normal_cones.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/outward.h"
#include "core/base/tunables.h"
#include "core/index/shape_index.h"

namespace trivet {
namespace {

constexpr double kSlopeOfCones = 1.3 * kConeSlope;  // with the rounding of coordinates
constexpr double kShortest = 1e-6;       // of the diagonal: shorter edges have no direction
constexpr double kSameDirection = 1e-8;  // 1 - cosine
constexpr double kOnLimit = 1e-6;        // by which a corner may be beyond a limit
constexpr double kWidening = 4e-4;       // radians, for all rounding
constexpr double kFloatOfCones = 2e-7;   // more than the rounding of 1
constexpr size_t kMostLimits = 20;       // others are left out: the cone is larger then

/// Directions d with way . d <= most; `way` is unit.
struct DirectionLimit {
  Vec3 way;
  double most;
};

struct WideCone {
  Vec3 axis = Vec3::UnitZ();
  double cos = -1;  // above 1: none

  bool is_none() const { return cos > 1; }
  bool is_all() const { return cos <= -1; }
  double sin() const { return std::sqrt(std::max(0.0, 1 - cos * cos)); }
  /// By an angle.
  WideCone widened(double by) const {
    if (is_none()) return *this;
    // The angle's sine and cosine to first and second order are on the safe side.
    const double s = sin(), more = cos * (1 - 0.5 * by * by) - s * by;
    return {axis, s < by && cos < 0 ? -1 : std::max(-1.0, more)};
  }
};

Vec3 unit_or_z(const Vec3& v) {
  const double length = v.norm();
  return length > 0 && length < kInfinity ? Vec3(v / length) : Vec3::UnitZ();
}

/// The cone around an axis that holds all directions within all limits. The farthest of them is
/// opposite to the axis, the farthest of one limit's circle, or where two circles meet.
class FarthestDirection {
 public:
  FarthestDirection(std::span<const DirectionLimit> limits, const Vec3& axis) : m_axis(axis) {
    // Circles that nearly are the same one have no certain crossings; the first one counts.
    for (const DirectionLimit& l : limits)
      if (std::none_of(m_limits.begin(), m_limits.end(), [&](const DirectionLimit& known) {
            return known.way.dot(l.way) > 1 - kSameDirection;
          }))
        m_limits.push_back(l);
  }

  WideCone run() {
    consider(-m_axis);
    for (const DirectionLimit& l : m_limits) consider_farthest_of(l);
    for (size_t i = 0; i < m_limits.size(); ++i)
      for (size_t j = i + 1; j < m_limits.size(); ++j) consider_crossings(m_limits[i], m_limits[j]);
    return {m_axis, m_least};
  }

 private:
  void consider(const Vec3& d) {
    const double cos = m_axis.dot(d);
    if (cos >= m_least) return;
    for (const DirectionLimit& l : m_limits)
      if (l.way.dot(d) > l.most + kOnLimit) return;
    m_least = cos;
  }

  void consider_farthest_of(const DirectionLimit& l) {
    Vec3 beside = m_axis - m_axis.dot(l.way) * l.way;
    if (beside.squaredNorm() < 1e-18) beside = l.way.unitOrthogonal();
    consider(l.most * l.way - std::sqrt(1 - l.most * l.most) * beside.normalized());
  }

  void consider_crossings(const DirectionLimit& a, const DirectionLimit& b) {
    const double c = a.way.dot(b.way), det = 1 - c * c;
    if (det < kSameDirection) return;  // opposite ones: circles without a crossing
    const double of_a = (a.most - c * b.most) / det, of_b = (b.most - c * a.most) / det;
    const double squared = (1 - of_a * a.most - of_b * b.most) / det;
    if (squared < -kSameDirection) return;
    const Vec3 middle = of_a * a.way + of_b * b.way;
    const Vec3 up = std::sqrt(std::max(0.0, squared)) * a.way.cross(b.way);
    consider(middle + up);
    consider(middle - up);
  }

  const Vec3 m_axis;
  std::vector<DirectionLimit> m_limits;
  double m_least = 2;  // none so far
};

WideCone merged_cones(std::span<const WideCone> cones) {
  Vec3 sum = Vec3::Zero();
  bool any = false;
  for (const WideCone& c : cones) {
    if (c.is_none()) continue;
    any = true;
    sum += c.axis;
  }
  if (!any) return {Vec3::UnitZ(), 2};
  WideCone out{unit_or_z(sum), 1};
  for (const WideCone& c : cones) {
    if (c.is_none()) continue;
    // The farthest direction of each one is on the other side of its axis.
    const double cos = std::clamp(out.axis.dot(c.axis), -1.0, 1.0), sin = std::sqrt(1 - cos * cos);
    const double sin_of_sum = sin * c.cos + cos * c.sin();
    out.cos = std::min(out.cos, sin_of_sum <= 0 ? -1 : cos * c.cos - sin * c.sin());
  }
  return out;
}

NormalCone rounded_outwards(const WideCone& c) {
  if (c.is_none()) return NormalCone::none();
  NormalCone out;
  if (c.is_all()) return out;
  for (int k = 0; k < 3; ++k) out.axis[k] = static_cast<float>(c.axis[k]);
  out.cos = float_below(std::max(-1.0, c.cos - kFloatOfCones));
  out.sin = float_above(c.sin() + kFloatOfCones);
  return out;
}

/// As NormalCones::Part.
struct WidePart {
  WideCone outwards, inwards, normals;

  NormalCones::Part rounded() const {
    return {rounded_outwards(outwards), rounded_outwards(inwards), rounded_outwards(normals)};
  }
};

/// Cones on both sides of a surface.
struct SidedCones {
  WideCone outwards, inwards;

  /// All directions within the limits. @param out  the side that counts as outwards.
  static SidedCones within(std::vector<DirectionLimit> limits, const Vec3& out) {
    SidedCones cones;
    for (const bool outwards : {true, false}) {
      const Vec3 axis = outwards ? out : Vec3(-out);
      limits.push_back({-axis, 0});
      WideCone& cone = outwards ? cones.outwards : cones.inwards;
      cone = FarthestDirection(limits, axis).run().widened(kWidening);
      limits.pop_back();
    }
    return cones;
  }
  WidePart with(const WideCone& normals) const { return {outwards, inwards, normals}; }
};

WidePart merged_parts(std::span<const WidePart> parts) {
  WidePart out;
  for (WideCone WidePart::*which : {&WidePart::outwards, &WidePart::inwards, &WidePart::normals}) {
    std::vector<WideCone> cones;
    for (const WidePart& p : parts) cones.push_back(p.*which);
    out.*which = merged_cones(cones);
  }
  return out;
}

class ConeMaker {
 public:
  explicit ConeMaker(const Shape& shape)
      : m_mesh(shape.mesh),
        m_adjacency(shape.adjacency),
        m_shortest(kShortest * shape.box.diagonal()),
        m_slack(kSlackOfCones * shape.box.diagonal()) {}

  NormalCones run(const Bvh& bvh) {
    for (Index v = 0; v < static_cast<Index>(m_mesh.vertices.size()); ++v)
      m_vertices.push_back(of_vertex(v));
    for (Index e = 0; e < static_cast<Index>(m_adjacency.edge_vertices.size()); ++e)
      m_edges.push_back(of_edge(e));
    std::vector<WidePart> faces;
    for (Index f = 0; f < static_cast<Index>(m_mesh.triangles.size()); ++f)
      faces.push_back(of_face(f));
    NormalCones out;
    for (const WidePart& f : faces) out.faces.push_back(f.rounded());
    for (const WidePart& n : of_nodes(bvh, faces)) out.nodes.push_back(n.rounded());
    for (const SidedCones& v : m_vertices) out.vertices.push_back(v.with({}).rounded());
    for (size_t e = 0; e < m_edges.size(); ++e)
      out.edges.push_back(with_ends(static_cast<Index>(e)).rounded());
    return out;
  }

 private:
  SidedCones of_vertex(Index v) const {
    const auto edges = m_adjacency.vertex_edges[v];
    std::vector<DirectionLimit> limits;
    // Some edges of a fan are enough.
    const size_t step = 1 + edges.size() / kMostLimits;
    for (size_t k = 0; k < edges.size(); k += step) {
      const auto& ends = m_adjacency.edge_vertices[edges[k]];
      const Vec3 d = m_mesh.vertices[ends[0] == v ? ends[1] : ends[0]] - m_mesh.vertices[v];
      if (d.norm() > m_shortest) limits.push_back({d.normalized(), kSlopeOfCones});
    }
    Vec3 around = Vec3::Zero();
    for (const Index f : m_adjacency.vertex_faces[v]) around += area_normal(f);
    return SidedCones::within(std::move(limits), unit_or_z(around));
  }

  // It counts places that are apart from its ends.
  SidedCones of_edge(Index e) const {
    const auto& ends = m_adjacency.edge_vertices[e];
    const Vec3 from = m_mesh.vertices[ends[0]], along = m_mesh.vertices[ends[1]] - from;
    const double length = along.norm();
    if (!(length > m_shortest)) return {};
    const Vec3 unit = along / length;
    std::vector<DirectionLimit> limits{{unit, kSlopeOfCones}, {-unit, kSlopeOfCones}};
    Vec3 around = Vec3::Zero();
    for (const Wing& wing : m_adjacency.edge_faces[e]) {
      around += unit_or_z(area_normal(wing.face));
      for (const Index v : m_mesh.triangles[wing.face])
        if (v != ends[0] && v != ends[1] && limits.size() < kMostLimits)
          add_limit(m_mesh.vertices[v] - from, unit, length, limits);
    }
    return SidedCones::within(std::move(limits), unit_or_z(around));
  }

  // `d` from an end of the edge to a vertex beside it.
  void add_limit(const Vec3& d, const Vec3& unit, double length,
                 std::vector<DirectionLimit>& limits) const {
    const Vec3 across = d - d.dot(unit) * unit;
    const double height = across.norm();
    if (!(height > m_shortest)) return;
    // Wherever on the edge the contact is, the slope is of the way from there, part of which is
    // along the edge.
    const double farthest = std::max(d.norm(), (d - length * unit).norm()) + m_slack;
    const double most = 2 * kSlopeOfCones * farthest / height;
    if (most < 0.5) limits.push_back({across / height, most});
  }

  Vec3 area_normal(Index face) const {
    const Triangle t = m_mesh.triangle(face);
    return (t[1] - t[0]).cross(t[2] - t[0]);
  }

  WidePart of_face(Index face) const {
    std::vector<WidePart> all;
    const auto add = [&](const SidedCones& c) { all.push_back(c.with(of_normal(face))); };
    for (const Index v : m_mesh.triangles[face]) add(m_vertices[v]);
    for (const Index e : m_adjacency.face_edges[face])
      if (e >= 0) add(m_edges[e]);
    return merged_parts(all);
  }

  // Near its ends an edge touches as they do.
  WidePart with_ends(Index e) const {
    std::vector<WidePart> all{m_edges[e].with({})};
    for (const Index v : m_adjacency.edge_vertices[e]) all.push_back(m_vertices[v].with({}));
    return merged_parts(all);
  }

  WideCone of_normal(Index face) const {
    const Triangle t = m_mesh.triangle(face);
    const double longest =
        std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    const Vec3 normal = area_normal(face);
    // The normal of a thin face is rounding.
    if (!(normal.norm() > m_shortest * longest)) return {};
    // Flat faces touch that are parallel to within the slope.
    return WideCone{normal.normalized(), 1}.widened(kConeSlope + kWidening);
  }

  static std::vector<WidePart> of_nodes(const Bvh& bvh, const std::vector<WidePart>& faces) {
    std::vector<WidePart> nodes(bvh.nodes.size());
    for (auto id = static_cast<Index>(nodes.size()); id-- > 0;) {
      const BvhNode& node = bvh.nodes[id];
      std::vector<WidePart> parts;
      // Children have higher ids, and are there before their parents.
      if (!node.is_leaf()) parts = {nodes[id + 1], nodes[node.second_child]};
      for (Index i = 0; i < node.num_faces; ++i)
        parts.push_back(faces[bvh.faces[node.second_child + i]]);
      nodes[id] = merged_parts(parts);
    }
    return nodes;
  }

  const Mesh& m_mesh;
  const Adjacency& m_adjacency;
  const double m_shortest, m_slack;
  std::vector<SidedCones> m_vertices, m_edges;
};

}  // namespace

const NormalCones& normal_cones_of(const Shape& shape) {
  const Bvh& bvh = shape.bvh();
  return shape.index->cones.get([&] { return ConeMaker(shape).run(bvh); });
}

bool has_normal_cones(const Shape& shape) { return shape.index->cones.is_made(); }

}  // namespace trivet
