// Depths of parts by rays upwards through the faces of those around them. Predicates are those of
// floating point: rays that pass near an edge or a surface say nothing, and another one is asked.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/mesh/moments.h"
#include "core/mesh/solid_faces.h"

namespace trivet {
namespace {

constexpr double kLeastVolume = 1e-9;  // of area x box diagonal; below, it is rounding
constexpr double kNear = 1e-9;         // of the products that a sign is computed from
constexpr size_t kMaxSamples = 32;     // faces of a part
// Bounds for files made to take long; parts beyond them count as side by side.
constexpr size_t kMaxPairs = 4'000'000;
constexpr std::int64_t kMaxTests = 500'000'000;  // of a ray and a face

// Parts and their faces, without those that count nowhere.
class PartFaces {
 public:
  PartFaces(const Adjacency& adjacency, const SolidFaces& solid)
      : m_faces(adjacency.components.size()) {
    for (Index f = 0; f < static_cast<Index>(adjacency.face_component.size()); ++f)
      if (solid.weight(f) != 0) m_faces[adjacency.face_component[f]].push_back(f);
  }
  const std::vector<Index>& operator[](Index part) const { return m_faces[part]; }

 private:
  std::vector<std::vector<Index>> m_faces;
};

// Sign of the area of a, b, p seen from above; nullopt: too near to tell.
std::optional<int> side_of(const Vec3& a, const Vec3& b, const Vec3& p) {
  // The bound is relative to the two products, as their rounding is.
  const double left = (b.x() - a.x()) * (p.y() - a.y()), right = (b.y() - a.y()) * (p.x() - a.x());
  const double difference = left - right;
  if (std::abs(difference) <= kNear * (std::abs(left) + std::abs(right))) return std::nullopt;
  return difference > 0 ? 1 : -1;
}

// +1 or -1: the ray from p upwards goes through the face, from below or above; 0: it misses it.
std::optional<int> crossing(const Triangle& t, const Vec3& p) {
  if (!side_of(t[0], t[1], t[2])) return 0;  // upright: its neighbours tell
  // The point is inside the face as seen from above if it is on the same side of all edges.
  int sides[3];
  for (int k = 0; k < 3; ++k) {
    const auto side = side_of(t[k], t[(k + 1) % 3], p);
    if (!side) return std::nullopt;
    sides[k] = *side;
  }
  if (sides[0] != sides[1] || sides[1] != sides[2]) return 0;
  // The point is above or below the plane by the sign of its height; near it, nothing is told.
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double height = normal.dot(p - t[0]);
  if (std::abs(height) <= kNear * normal.norm() * (p - t[0]).norm()) return std::nullopt;
  return (height > 0) == (sides[0] > 0) ? 0 : sides[0];
}

/// Faces of a part in columns along z.
class Columns {
 public:
  Columns(const Mesh& mesh, const SolidFaces& solid, const std::vector<Index>& faces,
          const Aabb& box)
      : m_mesh(mesh), m_solid(solid), m_box(box) {
    m_size = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(faces.size()))), 1, 1024);
    // Long faces are in many columns: fewer of these then.
    while (m_size > 1 && num_entries(faces) > 8 * static_cast<std::int64_t>(faces.size()))
      m_size /= 2;
    m_cells.resize(static_cast<size_t>(m_size) * static_cast<size_t>(m_size));
    for (const Index f : faces) add(f);
  }

  // nullopt: on the surface, or the ray grazes.
  std::optional<bool> holds(const Vec3& p, std::int64_t& num_tests) const {
    int winding = 0;
    // A ray upwards meets only faces of its own column.
    const auto& faces = m_cells[cell(column(p.x(), 0), column(p.y(), 1))];
    num_tests += static_cast<std::int64_t>(faces.size());
    for (const Index f : faces) {
      const auto sign = crossing(m_mesh.triangle(f), p);
      if (!sign) return std::nullopt;
      // Faces count by their weights: copies and walls were left out.
      winding += *sign * static_cast<int>(m_solid.weight(f));
    }
    return winding != 0;
  }

 private:
  int column(double x, int axis) const {
    const double width = m_box.upper[axis] - m_box.lower[axis];
    const double at = width > 0 ? (x - m_box.lower[axis]) / width * m_size : 0;
    return std::clamp(static_cast<int>(at), 0, m_size - 1);
  }
  size_t cell(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(m_size) + static_cast<size_t>(x);
  }
  // First and last column along x, then y.
  std::array<int, 4> columns_of(Index f) const {
    Aabb box;
    for (const Vec3& p : m_mesh.triangle(f)) box.extend(p);
    return {column(box.lower.x(), 0), column(box.upper.x(), 0), column(box.lower.y(), 1),
            column(box.upper.y(), 1)};
  }
  std::int64_t num_entries(const std::vector<Index>& faces) const {
    std::int64_t count = 0;
    for (const Index f : faces) {
      const auto [x0, x1, y0, y1] = columns_of(f);
      count += std::int64_t{x1 - x0 + 1} * (y1 - y0 + 1);
    }
    return count;
  }
  void add(Index f) {
    const auto [x0, x1, y0, y1] = columns_of(f);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) m_cells[cell(x, y)].push_back(f);
  }

  const Mesh& m_mesh;
  const SolidFaces& m_solid;
  const Aabb m_box;
  int m_size = 1;
  std::vector<std::vector<Index>> m_cells;
};

// A point of a face that lies on no line that meshes are likely to have.
Vec3 sample_of(const Triangle& t) { return 0.5123 * t[0] + 0.2914 * t[1] + 0.1963 * t[2]; }

// True if all samples that can be told are inside, and one can.
bool is_inside(const Mesh& mesh, const std::vector<Index>& faces, const Columns& outer,
               std::int64_t& num_tests) {
  bool any = false;
  // At most kMaxSamples faces are asked, spread over the part.
  const size_t step = faces.size() / kMaxSamples + 1;
  for (size_t i = 0; i < faces.size(); i += step) {
    const auto inside = outer.holds(sample_of(mesh.triangle(faces[i])), num_tests);
    // One sample outside settles it, as closed parts that do not cross are wholly in or out.
    if (inside && !*inside) return false;
    any |= inside.has_value();
  }
  return any;
}

bool contains(const Aabb& outer, const Aabb& inner) {
  return (outer.lower.array() <= inner.lower.array()).all() &&
         (outer.upper.array() >= inner.upper.array()).all();
}

class Nesting {
 public:
  Nesting(const Mesh& mesh, const SolidFaces& solid, Adjacency& adjacency)
      : m_mesh(mesh), m_solid(solid), m_parts(adjacency.components), m_adjacency(adjacency) {}

  void find() {
    // Parts without volume hold nothing and lie in nothing.
    measure();
    for (Index c = 0; c < static_cast<Index>(m_parts.size()); ++c)
      if (m_solid.closed[c] && std::abs(m_volumes[c]) > kLeastVolume * m_sizes[c])
        m_solids.push_back(c);
    std::int64_t num_tests = 0;
    for (const auto& [outer, inner] : candidates()) {
      if (num_tests > kMaxTests) break;
      if (!m_faces) m_faces.emplace(m_adjacency, m_solid);
      // Pairs come by the outer part, whose columns serve all of its inner ones.
      if (outer != m_columns_of) {
        m_columns.emplace(m_mesh, m_solid, (*m_faces)[outer], m_parts[outer].box);
        m_columns_of = outer;
      }
      m_parts[inner].depth += is_inside(m_mesh, (*m_faces)[inner], *m_columns, num_tests);
    }
    // A part of odd depth is a cavity, wound inwards: the winding tells which parts are not as they
    // should be.
    for (const Index c : m_solids)
      m_parts[c].winding = (m_volumes[c] > 0) == (m_parts[c].depth % 2 == 0) ? 1 : -1;
  }

 private:
  void measure() {
    m_volumes.assign(m_parts.size(), 0);
    m_sizes.assign(m_parts.size(), 0);
    for (Index f = 0; f < static_cast<Index>(m_mesh.triangles.size()); ++f) {
      const Index c = m_adjacency.face_component[f];
      if (!m_solid.closed[c]) continue;
      // Volumes about the part's own middle lose no digits to its place.
      const Triangle t = relative_to(m_parts[c].box.centre(), m_mesh.triangle(f));
      m_volumes[c] += m_solid.weight(f) * signed_volume(t);
      m_sizes[c] += area_of(t);
    }
    for (size_t c = 0; c < m_parts.size(); ++c) m_sizes[c] *= m_parts[c].box.diagonal();
  }

  // Pairs of a part and one whose box lies in its box, by the outer one: a sweep along x.
  std::vector<std::pair<Index, Index>> candidates() const {
    std::vector<Index> order = m_solids;
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      return m_parts[a].box.lower.x() < m_parts[b].box.lower.x();
    });
    std::vector<std::pair<Index, Index>> out;
    std::vector<Index> open;
    // Parts whose box ended before this one begins cannot hold it, nor lie in it.
    for (size_t i = 0; i < order.size() && out.size() < kMaxPairs; ++i) {
      const Aabb& box = m_parts[order[i]].box;
      std::erase_if(open, [&](Index c) { return m_parts[c].box.upper.x() < box.lower.x(); });
      for (const Index c : open) {
        if (contains(m_parts[c].box, box))
          out.emplace_back(c, order[i]);
        else if (contains(box, m_parts[c].box))
          out.emplace_back(order[i], c);
      }
      open.push_back(order[i]);
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  const Mesh& m_mesh;
  const SolidFaces& m_solid;
  std::vector<Component>& m_parts;
  const Adjacency& m_adjacency;
  std::vector<double> m_volumes, m_sizes;
  std::vector<Index> m_solids;
  std::optional<PartFaces> m_faces;
  std::optional<Columns> m_columns;
  Index m_columns_of = -1;
};

}  // namespace

void nest_components(const Mesh& mesh, const SolidFaces& solid, Adjacency& adjacency) {
  Nesting(mesh, solid, adjacency).find();
}

}  // namespace trivet
