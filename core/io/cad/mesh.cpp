// Polygonisation: each part once, to the requested chord, then placed in all its positions.
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Eigen/Geometry>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeUpgrade_ShapeDivideClosed.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <numbers>
#include <set>

#include "core/base/error.h"
#include "core/base/float32.h"
#include "core/base/tunables.h"
#include "core/io/cad/faces.h"
#include "core/io/cad/parts.h"

namespace trivet {
namespace {

constexpr double kMetresPerMillimetre = 1e-3;

[[noreturn]] void fail(const Model& model, const Sentence& reason) {
  throw Error(Error::Kind::BadInput, "%1: %2", model.path, reason);
}

std::string metres(double millimetres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g m", millimetres * kMetresPerMillimetre);
  return text;
}

/// A shape prepared for the mesher: divided and sewn, so that its faces are new ones.
struct PreparedShape {
  TopoDS_Shape shape;
  bool sewn = false;
  int num_edges = 0;                        // as the part has them
  TopTools_DataMapOfShapeInteger original;  // face -> its number in `faces`
  std::vector<TopoDS_Shape> faces;          // as the part has them
};

bool has_loose_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  for (int i = 1; i <= faces_of_edge.Extent(); ++i)
    if (faces_of_edge(i).Extent() == 1 &&
        !BRep_Tool::Degenerated(TopoDS::Edge(faces_of_edge.FindKey(i))))
      return true;
  return false;
}

/// Divides faces that close in on themselves, such as a sphere or the skin of a loft, in four:
/// otherwise the mesher spans their inside (Open CASCADE 7.6: a lofted spoon loses a fifth of its
/// volume). Then sews faces that share no edges, as in IGES, along them; in the reverse order a
/// torus could not be meshed.
PreparedShape prepared(const TopoDS_Shape& shape, double tolerance) {
  PreparedShape out;
  out.shape = shape;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  out.num_edges = edges.Extent();
  ShapeUpgrade_ShapeDivideClosed divide(shape);
  divide.SetNbSplitPoints(3);
  const bool divided = divide.Perform() && !divide.Result().IsNull();
  if (divided) out.shape = divide.Result();
  BRepBuilderAPI_Sewing sewing(tolerance);
  if (has_loose_edges(out.shape)) {
    sewing.Add(out.shape);
    sewing.Perform();
    out.sewn = !sewing.SewedShape().IsNull();
    if (out.sewn) out.shape = sewing.SewedShape();
  }
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Shape now = divided ? divide.GetContext()->Apply(it.Current()) : it.Current();
    for (TopExp_Explorer piece(now, TopAbs_FACE); piece.More(); piece.Next())
      out.original.Bind(out.sewn ? sewing.ModifiedSubShape(piece.Current()) : piece.Current(),
                        static_cast<int>(out.faces.size()));
    out.faces.push_back(it.Current());
  }
  return out;
}

double size_of(const CadParts& parts) {
  Bnd_Box box;
  for (const CadPart& part : parts.parts) {
    Bnd_Box of_part;
    BRepBndLib::Add(part.shape, of_part, false);
    if (!of_part.IsVoid()) box.Add(of_part.Transformed(part.place));
  }
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

/// A triangulated shape, for all its placements.
struct Polygonised {
  PreparedShape prepared;
  PartMesh mesh;
  int num_failed = 0;    // faces of the part
  double deviation = 0;  // millimetres
};

class Polygoniser {
 public:
  /// @param chord  millimetres.
  Polygoniser(const ImportLimits& limits, double chord, double size, Model& model)
      : m_limits(limits), m_chord(chord), m_size(size), m_model(model) {}

  void add(const CadPart& part) {
    const Polygonised& shape = polygonised(part.shape);
    Polygonisation& done = *m_model.polygonised;
    done.num_edges += shape.prepared.num_edges;
    const int num_faces = static_cast<int>(shape.prepared.faces.size());
    done.num_failed_faces += shape.num_failed;
    done.num_faces += num_faces - shape.num_failed;
    done.deviation = std::max(done.deviation, kMetresPerMillimetre * shape.deviation);
    check_count(shape.mesh);
    const size_t first = m_triangles.size();
    double volume = 0;
    for (const FaceMesh& face : shape.mesh.faces())
      volume += add(face, part.place, material_of(part, shape.prepared, face.face));
    if (shape.prepared.sewn && volume < 0) turn_from(first);
  }

  void take() {
    m_model.mesh = weld(m_triangles);
    m_model.corner_normals = std::move(m_normals);
  }

 private:
  const Polygonised& polygonised(const TopoDS_Shape& shape) {
    int number = static_cast<int>(m_done.size());
    if (m_number_of.Find(shape, number)) return m_done[number];
    const double tolerance = std::min(m_chord / 4, kSewingTolerance * m_size);
    PreparedShape ready = prepared(shape, tolerance);
    double deviation = 0;
    PartMesh mesh = meshed(ready.shape, deviation);
    const int num_failed = num_original(ready, mesh.failed());
    m_number_of.Bind(shape, number);
    m_done.push_back({std::move(ready), std::move(mesh), num_failed, deviation});
    return m_done.back();
  }

  /// Reduces the tolerance until the measured deviation is within the requested one, or stops
  /// improving: the mesher fails on some surfaces.
  PartMesh meshed(const TopoDS_Shape& shape, double& deviation) {
    IMeshTools_Parameters parameters;
    parameters.Deflection = m_chord;
    parameters.Angle = m_model.tessellation.facet_angle_deg * std::numbers::pi / 180;
    double before = kInfinity;
    for (int trial = 0;; ++trial, before = deviation) {
      BRepTools::Clean(shape);  // files may contain meshes
      BRepMesh_IncrementalMesh(shape, parameters);
      PartMesh mesh(shape);
      check_count(mesh);
      deviation = chord_deviation(mesh);
      if (deviation <= m_chord || deviation > 0.95 * before || trial == kMaxPolygonisations)
        return mesh;
      parameters.Deflection *= std::max(0.25, 0.8 * m_chord / deviation);
    }
  }

  void check_count(const PartMesh& mesh) const {
    const auto count = static_cast<std::int64_t>(m_triangles.size()) + mesh.num_triangles();
    if (count > m_limits.max_triangles)
      fail(m_model, say("gives more than %1 triangles, the limit, at a chord of %2",
                        m_limits.max_triangles, metres(m_chord)));
  }

  static int num_original(const PreparedShape& shape, const std::vector<TopoDS_Face>& faces) {
    std::set<int> numbers;
    int number = -1;
    for (const TopoDS_Face& face : faces)
      if (shape.original.Find(face, number)) numbers.insert(number);
    return static_cast<int>(numbers.size());
  }

  static int material_of(const CadPart& part, const PreparedShape& shape, const TopoDS_Face& face) {
    int number = -1, material = part.material;
    if (shape.original.Find(face, number)) part.face_materials.Find(shape.faces[number], material);
    return material;
  }

  /// @return six times the signed volume, cubic metres.
  double add(const FaceMesh& mesh, const gp_Trsf& place, int material) {
    const BRepAdaptor_Surface surface(mesh.face);
    const bool turned = mesh.face.Orientation() == TopAbs_REVERSED;
    std::vector<Vec3> points, normals;
    for (const CadNode& node : mesh.nodes) {
      const gp_Pnt p = gp_Pnt(node.position.x(), node.position.y(), node.position.z());
      const Vec3 point = kMetresPerMillimetre * to_vec3(p.Transformed(place));
      points.push_back(as_float32(point));
      if (!points.back().allFinite()) fail(m_model, "has coordinates that are not finite");
      gp_Pnt ignored;
      gp_Vec du, dv;
      surface.D1(node.uv.X(), node.uv.Y(), ignored, du, dv);
      const Vec3 normal = to_vec3(du.Crossed(dv).Transformed(place));
      normals.push_back(turned ? Vec3(-normal) : normal);
    }
    double volume = 0;
    for (Index3 t : mesh.triangles) {
      if (place.IsNegative()) std::swap(t[1], t[2]);
      volume += add({points[t[0]], points[t[1]], points[t[2]]},
                    {normals[t[0]], normals[t[1]], normals[t[2]]}, material);
    }
    return volume;
  }

  double add(const Triangle& t, const std::array<Vec3, 3>& normals, int material) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      return 0;  // where an edge of the surface is a point
    const Vec3 flat = (t[1] - t[0]).cross(t[2] - t[0]);
    std::array<Eigen::Vector3f, 3> corners;
    for (int k = 0; k < 3; ++k) {
      // A surface has no normal at its poles, and may be mirrored.
      Vec3 n = normals[k].allFinite() && normals[k].squaredNorm() > 1e-24 ? normals[k] : flat;
      if (n.dot(flat) < 0) n = -n;
      if (!(n.norm() > 0)) n = Vec3::UnitZ();
      corners[k] = n.normalized().cast<float>();
    }
    m_triangles.push_back(t);
    m_normals.push_back(corners);
    m_model.face_material.push_back(material);
    return t[0].dot(t[1].cross(t[2]));
  }

  /// Reverses triangles that were sewn inside out.
  void turn_from(size_t first) {
    for (size_t i = first; i < m_triangles.size(); ++i) {
      std::swap(m_triangles[i][1], m_triangles[i][2]);
      std::swap(m_normals[i][1], m_normals[i][2]);
      for (auto& n : m_normals[i]) n = -n;
    }
  }

  const ImportLimits& m_limits;
  const double m_chord, m_size;  // millimetres
  Model& m_model;
  TopTools_DataMapOfShapeInteger m_number_of;  // of shapes in m_done
  std::vector<Polygonised> m_done;
  std::vector<Triangle> m_triangles;  // metres
  std::vector<std::array<Eigen::Vector3f, 3>> m_normals;
};

}  // namespace

void polygonise(const CadParts& parts, const ImportLimits& limits, Model& model) {
  const double size = size_of(parts);
  if (!(size > 0)) fail(model, "has no surface");
  const double wanted = model.tessellation.chord / kMetresPerMillimetre;
  const double chord = wanted > 0 ? wanted : kRelativeChord * size;
  if (chord < kSmallestRelativeChord * size)
    fail(model, say("a chord of %1 is too small for its size; accepted: at least %2", metres(chord),
                    metres(kSmallestRelativeChord * size)));
  model.polygonised.emplace().chord = chord * kMetresPerMillimetre;
  Polygoniser polygoniser(limits, chord, size, model);
  for (const CadPart& part : parts.parts) polygoniser.add(part);
  polygoniser.take();
  if (model.mesh.triangles.empty()) fail(model, "has no surface");
}

}  // namespace trivet
