// Private. Open CASCADE's meshes of a part's faces, joined along shared edges.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <map>
#include <vector>

#include "core/mesh/mesh.h"

class TopoDS_Edge;

namespace trivet {

inline Vec3 to_vec3(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
inline Vec3 to_vec3(const gp_Vec& v) { return {v.X(), v.Y(), v.Z()}; }

/// A node of a face's mesh: its position, and its parameters on the surface.
struct CadNode {
  Vec3 position;  // millimetres, frame of the part
  gp_Pnt2d uv;
  int free = 0;  // 1, 2: u or v is meaningless here, as at a sphere's poles
};

struct FaceMesh {
  TopoDS_Face face;
  std::vector<CadNode> nodes;
  std::vector<Index3> triangles;  // counter-clockwise seen from outside
};

/// Mesh of a shape that Open CASCADE has meshed. Nodes on shared edges and vertices coincide.
class PartMesh {
 public:
  explicit PartMesh(const TopoDS_Shape& shape);

  const std::vector<FaceMesh>& faces() const { return m_faces; }
  const std::vector<TopoDS_Face>& failed() const { return m_failed; }  // without a mesh
  std::int64_t num_triangles() const;

 private:
  void add(const TopoDS_Face& face);
  void join(const TopoDS_Face& face, const TopoDS_Edge& edge, std::vector<CadNode>& nodes);

  TopTools_IndexedMapOfShape m_edges, m_vertices;
  std::map<std::pair<int, int>, Vec3> m_points;  // along edges; of vertices: -id
  std::vector<FaceMesh> m_faces;
  std::vector<TopoDS_Face> m_failed;
};

/// The largest distance, in millimetres, from points of the surfaces (seven per triangle) to the
/// triangle that approximates them.
double chord_deviation(const PartMesh& mesh);

}  // namespace trivet
