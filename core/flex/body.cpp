#include "core/flex/body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/flex/hinges.h"

namespace trivet::flex {
namespace {

// Faces with two equal corners have the edges between different ones.
void find_edges(Body& body) {
  for (const auto& face : body.faces)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({face[k], face[(k + 1) % 3]});
      if (low != high) body.edges.push_back({low, high});
    }
  // Faces share their edges: each is named by its ends in order, and kept once.
  std::sort(body.edges.begin(), body.edges.end());
  body.edges.erase(std::unique(body.edges.begin(), body.edges.end()), body.edges.end());
  // A sorted list finds a face's edges by halving; a cable's faces, which are segments, have one
  // edge.
  for (const auto& face : body.faces) {
    auto& edges = body.face_edges.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({face[k], face[(k + 1) % 3]});
      const std::array<int, 2> edge{low, high};
      const auto it = std::lower_bound(body.edges.begin(), body.edges.end(), edge);
      edges[k] = low == high ? edges[0] : static_cast<int>(it - body.edges.begin());
    }
  }
}

// Two columns: the places of b and c seen from a, in the plane of the triangle.
Membrane membrane(const std::array<int, 3>& corners, const Vec2& b, const Vec2& c) {
  Membrane out{corners, 0, {}};
  // Gradients of the shape functions are the rows of the inverse of (b c).
  const double determinant = b[0] * c[1] - b[1] * c[0];
  out.area = std::abs(determinant) / 2;
  out.gradient[1][0] = c[1] / determinant, out.gradient[1][1] = -c[0] / determinant;
  out.gradient[2][0] = -b[1] / determinant, out.gradient[2][1] = b[0] / determinant;
  for (int k = 0; k < 2; ++k) out.gradient[0][k] = -out.gradient[1][k] - out.gradient[2][k];
  return out;
}

void add_membrane(Body& body, const std::array<int, 3>& corners, const Vec2& b, const Vec2& c) {
  body.membranes.push_back(membrane(corners, b, c));
  body.face_area.push_back(body.membranes.back().area);
}

// Areas of contact and masses of what has faces.
void spread_areas(Body& body, size_t num_vertices) {
  body.vertex_area.assign(num_vertices, 0);
  body.edge_area.assign(body.edges.size(), 0);
  body.mass.assign(num_vertices, 0);
  body.pinned.assign(num_vertices, false);
  // Each vertex and each edge of a face has a third of its area.
  for (size_t f = 0; f < body.faces.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      body.vertex_area[body.faces[f][k]] += body.face_area[f] / 3;
      body.edge_area[body.face_edges[f][k]] += body.face_area[f] / 3;
      body.mass[body.faces[f][k]] += body.material.density * body.face_area[f] / 3;
    }
}

void add_faces(Body& body, const Grid& grid) {
  for (int j = 0; j < grid.num_v; ++j)
    for (int i = 0; i < grid.num_u; ++i) {
      const int a = grid.vertex(i, j), b = grid.vertex(i + 1, j), c = grid.vertex(i, j + 1),
                d = grid.vertex(i + 1, j + 1);
      // Diagonals alternate from cell to cell, so that the sheet has no preferred slant.
      if ((i + j) % 2 == 0)
        body.faces.insert(body.faces.end(), {{a, b, d}, {a, d, c}});
      else
        body.faces.insert(body.faces.end(), {{a, b, c}, {b, d, c}});
    }
}

bool is_rim(int i, int last) { return i == 0 || i == last; }

// Three vertices in a row along warp and weft, with half the width at the rims, and for each cell
// its twist. The orthotropic plate's energy, without a hinge.
void add_bending(Body& body, const Grid& grid) {
  const FlexMaterial& m = body.material;
  const double du = grid.length_u / grid.num_u, dv = grid.length_v / grid.num_v;
  // The second difference of three vertices in a row is their curvature times the squared distance.
  const auto row = [&](int a, int b, int c, double stiffness, bool rim) {
    body.stencils.push_back({3, {a, b, c, 0}, {1, -2, 1, 0}, stiffness * (rim ? 0.5 : 1)});
  };
  for (int j = 0; j <= grid.num_v; ++j)
    for (int i = 1; i < grid.num_u; ++i)
      row(grid.vertex(i - 1, j), grid.vertex(i, j), grid.vertex(i + 1, j),
          m.bending * dv / (du * du * du), is_rim(j, grid.num_v));
  for (int i = 0; i <= grid.num_u; ++i)
    for (int j = 1; j < grid.num_v; ++j)
      row(grid.vertex(i, j - 1), grid.vertex(i, j), grid.vertex(i, j + 1),
          m.bending * du / (dv * dv * dv), is_rim(i, grid.num_u));
  // The twist of a cell is the mixed difference of its four corners.
  for (int j = 0; j < grid.num_v; ++j)
    for (int i = 0; i < grid.num_u; ++i)
      body.stencils.push_back({4,
                               {grid.vertex(i, j), grid.vertex(i + 1, j), grid.vertex(i, j + 1),
                                grid.vertex(i + 1, j + 1)},
                               {1, -1, -1, 1},
                               2 * m.twist * m.bending / (du * dv)});
}

}  // namespace

double Body::weight() const {
  double sum = 0;
  for (const double m : mass) sum += m;
  return sum * kGravity;
}

double Body::mean_weight() const { return weight() / static_cast<double>(size()); }

double Body::pressure() const {
  return material.density * kGravity / (is_cable ? material.thickness : 1);
}

Body make_sheet(const Grid& grid, const FlexMaterial& material) {
  Body body;
  body.material = material;
  add_faces(body, grid);
  find_edges(body);
  // The rest shape is the flat sheet, warp along u and weft along v.
  for (int j = 0; j <= grid.num_v; ++j)
    for (int i = 0; i <= grid.num_u; ++i)
      body.rest.emplace_back(grid.length_u * i / grid.num_u, grid.length_v * j / grid.num_v);
  for (const auto& f : body.faces)
    add_membrane(body, f, body.rest[f[1]] - body.rest[f[0]], body.rest[f[2]] - body.rest[f[0]]);
  spread_areas(body, body.rest.size());
  const double du = grid.length_u / grid.num_u, dv = grid.length_v / grid.num_v;
  for (int j = 0; j <= grid.num_v; ++j)  // as the rectangles around the vertices
    for (int i = 0; i <= grid.num_u; ++i)
      body.mass[grid.vertex(i, j)] = material.density * du * dv *
                                     (is_rim(i, grid.num_u) ? 0.5 : 1) *
                                     (is_rim(j, grid.num_v) ? 0.5 : 1);
  add_bending(body, grid);
  body.cell = std::min(du, dv);
  return body;
}

Body make_cable(int num_segments, double length, const FlexMaterial& material) {
  Body body;
  body.is_cable = true;
  body.material = material;
  const double l = length / num_segments, area = l * material.thickness;
  body.cell = l;
  // Segments are faces of two equal corners, so that contact needs no case for cables.
  for (int i = 0; i < num_segments; ++i) {
    body.faces.push_back({i, i + 1, i + 1});
    body.springs.push_back({i, i + 1, l, material.stretch / l});
  }
  find_edges(body);
  const size_t count = static_cast<size_t>(num_segments) + 1;
  body.face_area.assign(num_segments, area);
  body.edge_area.assign(num_segments, area);
  body.vertex_area.assign(count, area);
  body.mass.assign(count, l * material.density);
  // The ends stand for half a segment.
  for (const size_t end : {size_t{0}, count - 1}) body.vertex_area[end] /= 2, body.mass[end] /= 2;
  body.pinned.assign(count, false);
  for (size_t i = 0; i < count; ++i) body.rest.emplace_back(l * static_cast<double>(i), 0);
  for (int i = 1; i < num_segments; ++i)
    body.stencils.push_back(
        {3, {i - 1, i, i + 1, 0}, {1, -2, 1, 0}, material.bending / (l * l * l)});
  return body;
}

Body make_mesh(const Points& rest, std::vector<std::array<int, 3>> faces,
               const FlexMaterial& material) {
  Body body;
  body.material = material;
  body.faces = std::move(faces);
  find_edges(body);
  body.cell = kInfinity;
  // A face is laid flat: its first edge along u, the third corner beside it.
  for (const auto& f : body.faces) {
    const Vec3 ab = rest[f[1]] - rest[f[0]], ac = rest[f[2]] - rest[f[0]];
    const double length = ab.norm(), along = ab.dot(ac) / length;
    add_membrane(body, f, {length, 0}, {along, ab.cross(ac).norm() / length});
  }
  // The shortest edge is the cell, against which steps and layers are measured.
  for (const auto& [a, b] : body.edges) body.cell = std::min(body.cell, (rest[a] - rest[b]).norm());
  spread_areas(body, rest.size());
  add_hinges(body, rest);
  for (const Vec3& p : rest) body.rest.emplace_back(p[0], p[1]);
  return body;
}

}  // namespace trivet::flex
