#include "core/flex/thick_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/float32.h"

namespace trivet::flex {
namespace {

constexpr int kSides = 12;
constexpr double kRootThreeHalves = 0.86602540378443865;
constexpr double kCosines[kSides] = {1,  kRootThreeHalves,  0.5,  0, -0.5, -kRootThreeHalves,
                                     -1, -kRootThreeHalves, -0.5, 0, 0.5,  kRootThreeHalves};

Vec3 unit(const Vec3& v, const Vec3& otherwise) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : otherwise;
}

class Builder {
 public:
  int vertex(const Vec3& p) {
    m_out.mesh.vertices.push_back(as_float32(p));
    return static_cast<int>(m_out.mesh.vertices.size()) - 1;
  }
  void face(const std::array<int, 3>& corners, const std::array<Vec3, 3>& normals) {
    m_out.mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    auto& row = m_out.corner_normals.emplace_back();
    for (int k = 0; k < 3; ++k) row[k] = normals[k].cast<float>();
  }
  void quad(int a, int b, int c, int d, const Vec3& at_a, const Vec3& at_b, const Vec3& at_c,
            const Vec3& at_d) {
    face({a, b, c}, {at_a, at_b, at_c});
    face({a, c, d}, {at_a, at_c, at_d});
  }
  const Vec3& at(int vertex) const { return m_out.mesh.vertices[vertex]; }
  ThickShape take() { return std::move(m_out); }

 private:
  ThickShape m_out;
};

Points vertex_normals(const Points& x, const std::vector<std::array<int, 3>>& faces) {
  Points out(x.size(), Vec3::Zero());
  for (const auto& f : faces) {
    const Vec3 normal = (x[f[1]] - x[f[0]]).cross(x[f[2]] - x[f[0]]);
    // The cross product weighs each face by its area.
    for (const int v : f) out[v] += normal;
  }
  for (Vec3& n : out) n = unit(n, Vec3::UnitZ());
  return out;
}

// Edges of one face, as that face runs through them.
std::vector<std::array<int, 2>> rim_of(const std::vector<std::array<int, 3>>& faces) {
  std::vector<std::array<int, 4>> all;  // sorted ends, then as the face has them
  for (const auto& f : faces)
    for (int k = 0; k < 3; ++k) {
      const int a = f[k], b = f[(k + 1) % 3];
      all.push_back({std::min(a, b), std::max(a, b), a, b});
    }
  std::sort(all.begin(), all.end());
  // An edge that comes once is a rim.
  const auto same = [&](size_t i, size_t j) {
    return j < all.size() && all[i][0] == all[j][0] && all[i][1] == all[j][1];
  };
  std::vector<std::array<int, 2>> out;
  for (size_t i = 0; i < all.size(); ++i)
    if (!same(i, i + 1) && (i == 0 || !same(i, i - 1))) out.push_back({all[i][2], all[i][3]});
  return out;
}

// Directions across a line at each vertex, turned as little as possible from one to the next.
Points frames(const Points& line, Points& across) {
  Points along;
  // The direction at a vertex is that of its neighbours' chord.
  for (size_t i = 0; i < line.size(); ++i)
    along.push_back(
        unit(line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0], Vec3::UnitX()));
  Vec3 u = std::abs(along[0].x()) > 0.9 ? Vec3::UnitY() : Vec3::UnitX();
  // The last frame is carried on, without its part along the line: no twist is added.
  for (const Vec3& t : along) {
    u = unit(u - t * t.dot(u), t.unitOrthogonal());
    across.push_back(u);
  }
  return along;
}

void add_end(Builder& builder, const std::vector<int>& ring, const Vec3& middle,
             const Vec3& outwards, bool is_first) {
  const int centre = builder.vertex(middle);
  for (int k = 0; k < kSides; ++k) {
    const int a = ring[k], b = ring[(k + 1) % kSides];
    builder.face(is_first ? std::array{centre, b, a} : std::array{centre, a, b},
                 {outwards, outwards, outwards});
  }
}

}  // namespace

ThickShape thick_sheet(const Points& middle, const std::vector<std::array<int, 3>>& faces,
                       double radius) {
  const Points normals = vertex_normals(middle, faces);
  Builder builder;
  const auto count = static_cast<int>(middle.size());
  // Two sheets, one on each side, with opposite faces.
  for (const double side : {radius, -radius})
    for (size_t v = 0; v < middle.size(); ++v) builder.vertex(middle[v] + side * normals[v]);
  for (const auto& [a, b, c] : faces) {
    builder.face({a, b, c}, {normals[a], normals[b], normals[c]});
    builder.face({count + a, count + c, count + b}, {-normals[a], -normals[c], -normals[b]});
  }
  // Rims are closed by a quad each.
  for (const auto& [a, b] : rim_of(faces)) {
    const Vec3 out = unit((middle[b] - middle[a]).cross(normals[a]), Vec3::UnitZ());
    builder.quad(b, a, count + a, count + b, out, out, out, out);
  }
  return builder.take();
}

ThickShape thick_cable(const Points& line, double radius) {
  Points across;
  const Points along = frames(line, across);
  Builder builder;
  std::vector<std::vector<int>> rings;
  std::vector<Points> normals;
  for (size_t i = 0; i < line.size(); ++i) {
    const Vec3 v = along[i].cross(across[i]);
    rings.emplace_back(), normals.emplace_back();
    for (int k = 0; k < kSides; ++k) {
      // The sine is the cosine a quarter turn, or nine of twelve sides, on.
      normals[i].push_back(kCosines[k] * across[i] + kCosines[(k + 9) % kSides] * v);
      rings[i].push_back(builder.vertex(line[i] + radius * normals[i][k]));
    }
  }
  // Neighbouring rings are joined by quads; caps close the ends.
  for (size_t i = 0; i + 1 < line.size(); ++i)
    for (int k = 0; k < kSides; ++k) {
      const int m = (k + 1) % kSides;
      builder.quad(rings[i][k], rings[i][m], rings[i + 1][m], rings[i + 1][k], normals[i][k],
                   normals[i][m], normals[i + 1][m], normals[i + 1][k]);
    }
  add_end(builder, rings.front(), line.front(), -along.front(), true);
  add_end(builder, rings.back(), line.back(), along.back(), false);
  return builder.take();
}

}  // namespace trivet::flex
