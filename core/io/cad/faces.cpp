#include "core/io/cad/faces.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>

#include "core/contact/triangle_distance.h"

namespace trivet {
namespace {

/// Parameters of a triangle's corners; free ones are taken from the others.
std::array<gp_Pnt2d, 3> parameters_of(const FaceMesh& mesh, const Index3& t) {
  std::array<gp_Pnt2d, 3> out;
  for (int k = 0; k < 3; ++k) out[k] = mesh.nodes[t[k]].uv;
  for (const int axis : {1, 2}) {
    double sum = 0;
    int count = 0;
    for (int k = 0; k < 3; ++k)
      if (mesh.nodes[t[k]].free != axis) sum += out[k].Coord(axis), ++count;
    for (int k = 0; count > 0 && k < 3; ++k)
      if (mesh.nodes[t[k]].free == axis) out[k].SetCoord(axis, sum / count);
  }
  return out;
}

/// Distance from a point to a triangle: to its plane if above its inside, else to the triangle.
double distance(const Vec3& p, const Triangle& t, const Vec3& normal) {
  bool inside = normal.squaredNorm() > 0;
  for (int k = 0; k < 3 && inside; ++k)
    inside = normal.dot((t[(k + 1) % 3] - t[k]).cross(p - t[k])) >= 0;
  if (inside) return std::abs(normal.dot(p - t[0])) / normal.norm();
  return closest_points({p, p, p}, t).distance;
}

double chord_deviation(const FaceMesh& mesh) {
  constexpr double kSamples[][3] = {{1 / 3., 1 / 3., 1 / 3.},
                                    {.5, .5, 0},
                                    {0, .5, .5},
                                    {.5, 0, .5},
                                    {2 / 3., 1 / 6., 1 / 6.},
                                    {1 / 6., 2 / 3., 1 / 6.},
                                    {1 / 6., 1 / 6., 2 / 3.}};
  const BRepAdaptor_Surface surface(mesh.face);
  double largest = 0;
  for (const Index3& t : mesh.triangles) {
    const auto uv = parameters_of(mesh, t);
    const Triangle triangle{mesh.nodes[t[0]].position, mesh.nodes[t[1]].position,
                            mesh.nodes[t[2]].position};
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    for (const auto& w : kSamples) {
      const gp_XY at = w[0] * uv[0].XY() + w[1] * uv[1].XY() + w[2] * uv[2].XY();
      const Vec3 on_surface = to_vec3(surface.Value(at.X(), at.Y()));
      largest = std::max(largest, distance(on_surface, triangle, normal));
    }
  }
  return largest;
}

}  // namespace

PartMesh::PartMesh(const TopoDS_Shape& shape) {
  TopExp::MapShapes(shape, TopAbs_EDGE, m_edges);
  TopExp::MapShapes(shape, TopAbs_VERTEX, m_vertices);
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    add(TopoDS::Face(it.Current()));
}

std::int64_t PartMesh::num_triangles() const {
  std::int64_t count = 0;
  for (const FaceMesh& face : m_faces) count += static_cast<std::int64_t>(face.triangles.size());
  return count;
}

void PartMesh::add(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
  if (mesh.IsNull() || mesh->NbTriangles() == 0) {
    m_failed.push_back(face);
    return;
  }
  FaceMesh out;
  out.face = face;
  const gp_Trsf& place = location.Transformation();
  for (int i = 1; i <= mesh->NbNodes(); ++i)
    out.nodes.push_back({to_vec3(mesh->Node(i).Transformed(place)),
                         mesh->HasUVNodes() ? mesh->UVNode(i) : gp_Pnt2d(), 0});
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    join(face, TopoDS::Edge(it.Current()), out.nodes);
  const bool turned = (face.Orientation() == TopAbs_REVERSED) != place.IsNegative();
  for (int i = 1; i <= mesh->NbTriangles(); ++i) {
    int a, b, c;
    mesh->Triangle(i).Get(a, b, c);
    if (turned) std::swap(b, c);
    out.triangles.push_back({a - 1, b - 1, c - 1});
  }
  m_faces.push_back(std::move(out));
}

/// Gives the nodes along an edge the positions they have on the first face.
void PartMesh::join(const TopoDS_Face& face, const TopoDS_Edge& edge, std::vector<CadNode>& nodes) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
  const Handle(Poly_PolygonOnTriangulation) polygon =
      BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
  if (polygon.IsNull()) return;
  const int e = m_edges.FindIndex(edge), count = polygon->NbNodes();
  const int first = m_vertices.FindIndex(TopExp::FirstVertex(edge));
  const int last = m_vertices.FindIndex(TopExp::LastVertex(edge));
  const bool is_point = BRep_Tool::Degenerated(edge);
  const auto node = [&](int i) -> CadNode& {
    return nodes[polygon->Nodes()(polygon->Nodes().Lower() + i) - 1];
  };
  const gp_Pnt2d from = node(0).uv, to = node(count - 1).uv;
  const int free = std::abs(to.X() - from.X()) > std::abs(to.Y() - from.Y()) ? 1 : 2;
  for (int i = 0; i < count; ++i) {
    if (is_point) node(i).free = free;
    std::pair<int, int> key{e, i};
    if (first > 0 && (i == 0 || is_point)) key = {-first, 0};
    if (last > 0 && i == count - 1) key = {-last, 0};
    Vec3& position = node(i).position;
    position = m_points.try_emplace(key, position).first->second;
  }
}

double chord_deviation(const PartMesh& mesh) {
  double largest = 0;
  for (const FaceMesh& face : mesh.faces()) largest = std::max(largest, chord_deviation(face));
  return largest;
}

}  // namespace trivet
