#include "ops/arrange/support_surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/contact/contact_points.h"
#include "core/index/ray.h"

namespace trivet {
namespace {

constexpr double kLevelTolerance = 1.0 / 1024;  // of the body's size
constexpr double kLeastHeadRoom = 1.0 / 256;    // of the body's size
constexpr double kLeastArea = 0.05;             // of what is seen from above
constexpr int kHeadRoomSamples = 200;

struct UpwardFace {
  Index face = 0;
  double area = 0;
  Vec3 centre = Vec3::Zero();
};

class Unions {
 public:
  explicit Unions(size_t count) : m_parent(count) {
    std::iota(m_parent.begin(), m_parent.end(), size_t{0});
  }
  size_t root(size_t i) {
    while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  // The smaller number stays.
  void join(size_t a, size_t b) {
    a = root(a), b = root(b);
    m_parent[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<size_t> m_parent;
};

// A cluster of faces while it grows.
struct Cluster {
  std::vector<UpwardFace> faces;
  Aabb box;
  double area = 0, moment = 0;

  double height() const { return moment / area; }
  void add(const UpwardFace& face, const Triangle& t) {
    faces.push_back(face);
    for (const Vec3& p : t) box.extend(p);
    area += face.area;
    moment += face.area * face.centre.z();
  }
  void add(const Cluster& other) {
    faces.insert(faces.end(), other.faces.begin(), other.faces.end());
    box.extend(other.box);
    area += other.area;
    moment += other.moment;
  }
};

class SurfaceSearch {
 public:
  explicit SurfaceSearch(const Body& body) : m_body(body), m_size(body.world_box.diagonal()) {}

  std::vector<SupportSurface> run() {
    find_faces();
    std::vector<Cluster> clusters = joined_levels(connected());
    std::vector<SupportSurface> out;
    for (const Cluster& cluster : clusters) {
      // Small surfaces, such as buttons and edges, are no place to set things down.
      if (cluster.area < kLeastArea * m_seen_area) continue;
      SupportSurface surface = surface_of(cluster);
      // A surface without head room is the top of something that another part covers.
      if (surface.head_room > kLeastHeadRoom * m_size) out.push_back(std::move(surface));
    }
    const auto key = [](const SupportSurface& s) {
      return std::tuple(s.height, s.lower.x(), s.lower.y());
    };
    std::sort(out.begin(), out.end(),
              [&](const SupportSurface& a, const SupportSurface& b) { return key(a) < key(b); });
    return out;
  }

 private:
  // +1 or -1 by which side of the faces is outside; 0: unknown.
  double outside() const {
    const auto& parts = m_body.shape->adjacency.components;
    // An open mesh has no outside: both sides of a face may be up.
    if (!std::all_of(parts.begin(), parts.end(), [](const Component& c) { return c.balanced; }))
      return 0;
    const Vec3 origin = m_body.world_box.centre();
    double volume = 0;
    for (Index f = 0; f < static_cast<Index>(m_body.shape->mesh.triangles.size()); ++f) {
      const Triangle t = m_body.triangle(f);
      volume += (t[0] - origin).dot((t[1] - origin).cross(t[2] - origin));
    }
    return volume < 0 ? -1 : 1;
  }

  void find_faces() {
    const double sign = outside();
    const auto count = static_cast<Index>(m_body.shape->mesh.triangles.size());
    m_number.assign(count, -1);
    for (Index f = 0; f < count; ++f) {
      const Triangle t = m_body.triangle(f);
      const Vec3 twice = (t[1] - t[0]).cross(t[2] - t[0]);
      const double length = twice.norm();
      const double up = sign == 0 ? std::abs(twice.z()) : sign * twice.z();
      // Faces that look up add up to the area seen from above; in open meshes both sides do, and
      // count half each.
      if (up > 0) m_seen_area += (sign == 0 ? 0.25 : 0.5) * up;
      if (!(length > 0) || up < kSupportCosine * length) continue;
      m_number[f] = static_cast<Index>(m_faces.size());
      m_faces.push_back({f, 0.5 * length, (t[0] + t[1] + t[2]) / 3});
    }
  }

  std::vector<Cluster> connected() {
    // Faces that share an edge and look up are one surface.
    Unions unions(m_faces.size());
    const Adjacency& adjacency = m_body.shape->adjacency;
    for (Index e = 0; e < adjacency.edge_faces.size(); ++e) {
      Index first = -1;
      for (const Wing& wing : adjacency.edge_faces[e]) {
        const Index here = m_number[wing.face];
        if (here < 0) continue;
        if (first >= 0) unions.join(first, here);
        first = here;
      }
    }
    std::vector<Cluster> out;
    std::vector<size_t> cluster_of(m_faces.size());
    for (size_t i = 0; i < m_faces.size(); ++i) {
      const size_t root = unions.root(i);
      if (root == i) {
        cluster_of[i] = out.size();
        out.emplace_back();
      }
      out[cluster_of[root]].add(m_faces[i], m_body.triangle(m_faces[i].face));
    }
    return out;
  }

  // Flat clusters of one height that touch, seen from above.
  std::vector<Cluster> joined_levels(std::vector<Cluster> clusters) const {
    std::stable_sort(clusters.begin(), clusters.end(),
                     [](const Cluster& a, const Cluster& b) { return a.height() < b.height(); });
    // Tiles of one height that touch are one surface, though no edge joins them.
    const double tolerance = kLevelTolerance * m_size;
    std::vector<Cluster> out;
    for (const Cluster& cluster : clusters) {
      Cluster* found = nullptr;
      for (auto it = out.rbegin(); it != out.rend() && !found; ++it) {
        if (cluster.height() - it->height() > tolerance) break;
        if (overlaps(cluster.box, it->box, tolerance)) found = &*it;
      }
      if (found)
        found->add(cluster);
      else
        out.push_back(cluster);
    }
    return out;
  }

  SupportSurface surface_of(const Cluster& cluster) const {
    SupportSurface out;
    out.height = cluster.height();
    out.area = cluster.area;
    out.lowest = cluster.box.lower.z(), out.highest = cluster.box.upper.z();
    out.lower = cluster.box.lower.head<2>(), out.upper = cluster.box.upper.head<2>();
    // The outline is a hull: it spans holes and notches of the surface.
    std::vector<Vec2> corners;
    corners.reserve(3 * cluster.faces.size());
    for (const UpwardFace& face : cluster.faces)
      for (const Vec3& p : m_body.triangle(face.face)) corners.push_back(p.head<2>());
    out.outline = convex_hull(std::move(corners));
    out.head_room = head_room(cluster);
    return out;
  }

  // Median over the area: points of low discrepancy on the faces [Roberts 2018, R2 sequence], and
  // rays up from them.
  double head_room(const Cluster& cluster) const {
    const double start = 0.25 * kLeastHeadRoom * m_size;
    std::vector<double> rooms;
    rooms.reserve(kHeadRoomSamples);
    double passed = 0;
    size_t next = 0;
    for (int i = 0; i < kHeadRoomSamples; ++i) {
      // Samples are spread evenly over the area of the faces.
      const double wanted = (i + 0.5) / kHeadRoomSamples * cluster.area;
      while (next + 1 < cluster.faces.size() && passed + cluster.faces[next].area < wanted)
        passed += cluster.faces[next++].area;
      // The point is folded into the triangle.
      double u = 0.7548776662466927 * (i + 1), v = 0.5698402909980532 * (i + 1);
      u -= std::floor(u), v -= std::floor(v);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Triangle t = m_body.triangle(cluster.faces[next].face);
      Ray ray;
      // Rays begin above the face, so that they do not meet it.
      ray.origin = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]) + start * Vec3::UnitZ();
      ray.direction = Vec3::UnitZ();
      const auto hit = first_hit(*m_body.shape, m_body.world_from_object, ray);
      rooms.push_back(hit ? start + hit->time : kInfinity);
    }
    std::nth_element(rooms.begin(), rooms.begin() + kHeadRoomSamples / 2, rooms.end());
    return rooms[kHeadRoomSamples / 2];
  }

  const Body& m_body;
  double m_size;
  double m_seen_area = 0;
  std::vector<UpwardFace> m_faces;
  std::vector<Index> m_number;  // #F, in m_faces; -1: not upward
};

}  // namespace

std::vector<SupportSurface> support_surfaces(const Body& body) { return SurfaceSearch(body).run(); }

}  // namespace trivet
