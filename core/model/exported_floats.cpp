#include "core/model/exported_floats.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/float32.h"

namespace trivet {
namespace {

// A mesh farther than this many diagonals from its origin loses digits that centring preserves.
constexpr double kFarInDiagonals = 2.0;

// A scene that reaches farther, in metres and in diagonals, is exported about an origin of its own.
// Nearer, clearances that follow coordinates are below 16 micrometres or invisible beside it.
constexpr double kFarScene = 16.0;
constexpr double kFarSceneInDiagonals = 8.0;
// In a wide scene, what is farther, in metres and in its own diagonals, has a place of its own.
constexpr double kFarObjectInDiagonals = 4.0;

[[noreturn]] void fail_range(const ExportObject& object) {
  throw Error(Error::Kind::BadInput,
              "object '%1' lies beyond the range of float32, or its pose is not finite; it cannot "
              "be exported",
              object.name);
}

// World row -> glTF row: (x, z, -y). Sums run in the fixed order of Affine::apply.
Affine y_up_from_local(const Affine& world_from_object, const Vec3& centre) {
  const Vec3 translation = world_from_object.apply(centre);
  Affine out;
  out.linear.row(0) = world_from_object.linear.row(0);
  out.linear.row(1) = world_from_object.linear.row(2);
  out.linear.row(2) = -world_from_object.linear.row(1);
  out.translation = Vec3(translation.x(), translation.z(), -translation.y());
  return out;
}

Vec3 local_centre(const Aabb& mesh_box) {
  const bool far =
      !mesh_box.empty() && mesh_box.centre().norm() > kFarInDiagonals * mesh_box.diagonal();
  return far ? mesh_box.centre() : Vec3(Vec3::Zero());
}

float finite_float(double value, const ExportObject& object) {
  const float rounded = static_cast<float>(value);
  if (!std::isfinite(rounded)) fail_range(object);
  return rounded + 0.0f;  // readers multiply by their root matrix, which turns -0 into 0
}

}  // namespace

Vec3 export_origin(const Aabb& scene_box) {
  // Scenes near their origin are exported as they are.
  const double size = scene_box.diagonal(), reach = scene_box.max_abs_coordinate();
  if (!(size > 0) || !(reach > std::max(kFarScene, kFarSceneInDiagonals * size)))
    return Vec3::Zero();
  // A power of two of two to four diagonals: a scene that grows a little keeps its origin.
  const double grid = std::ldexp(1.0, std::ilogb(size) + 2);
  Vec3 origin = Vec3::Zero();
  if (!std::isfinite(grid) || !scene_box.centre().allFinite()) return origin;
  for (int i = 0; i < 3; ++i) origin[i] = grid * std::round(scene_box.centre()[i] / grid) + 0.0;
  return origin;
}

Vec3 export_place(const Affine& from_object, const Aabb& mesh_box) {
  Vec3 place = Vec3::Zero();
  if (mesh_box.empty()) return place;
  const Vec3 centre = from_object.apply(mesh_box.centre());
  // A place of its own is worth it only where float32 would lose what the object's size shows.
  const double size = mesh_box.diagonal() * from_object.linear.col(0).norm();
  const double near = std::max(kFarScene, kFarObjectInDiagonals * size);
  if (!centre.allFinite() || !(centre.cwiseAbs().maxCoeff() > near)) return place;
  const double grid = std::ldexp(1.0, std::ilogb(near));
  // The place must be exact in float32, as it goes to the file; farther away there is none.
  constexpr double kExactInFloat32 = 1 << 24;
  if (centre.cwiseAbs().maxCoeff() > kExactInFloat32 * grid) return place;
  for (int i = 0; i < 3; ++i) place[i] = grid * std::round(centre[i] / grid) + 0.0;
  return place;
}

Vec3 export_centre(const Model* model, const Aabb& mesh_box) {
  const Vec3 centre = local_centre(mesh_box);
  return model && model->appearance ? as_float32(centre) : centre;
}

ExportObject relative_to(const Vec3& origin, ExportObject object) {
  object.world_from_object = relative_to(origin, object.world_from_object);
  return object;
}

LocalVertices local_vertices(const Model& model) {
  LocalVertices out;
  // Vertices about the centre lose least when they become float32.
  out.centre = export_centre(&model, model.mesh.box());
  out.positions.reserve(model.mesh.vertices.size());
  for (const Vec3& p : model.mesh.vertices) out.positions.push_back((p - out.centre).cast<float>());
  return out;
}

NodeMatrix node_matrix(const ExportObject& object, const Vec3& centre) {
  const Affine exact = y_up_from_local(object.world_from_object, centre);
  NodeMatrix out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out[r][c] = finite_float(exact.linear(r, c), object);
    out[r][3] = finite_float(exact.translation[r], object);
  }
  return out;
}

ExportedPlacement::ExportedPlacement(const ExportObject& object, const Aabb& mesh_box)
    : m_place(export_place(object.world_from_object, mesh_box)),
      m_centre(export_centre(object.model.get(), mesh_box)),
      m_has_look(object.model && object.model->appearance && !object.model->rounded_appearance) {
  // The numbers as the file has them, so that positions are those of a reader.
  const NodeMatrix rows = node_matrix(relative_to(m_place, object), m_centre);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) m_y_up_from_local.linear(r, c) = rows[r][c];
    m_y_up_from_local.translation[r] = rows[r][3];
  }
}

Vec3 ExportedPlacement::operator()(const Vec3& vertex) const {
  // The order of roundings is the reader's: vertex, then matrix, then the place.
  Vec3 local = vertex - m_centre;
  // An appearance's float32 vertices pass through its own nodes, in double, as on import.
  if (!m_has_look) local = as_float32(local);
  const Vec3 y_up = as_float32(m_y_up_from_local.apply(local));
  return m_place + Vec3(y_up.x(), -y_up.z(), y_up.y());
}

std::vector<Eigen::Vector3f> exported_positions(const ExportObject& object) {
  const Mesh& mesh = object.model->mesh;
  const ExportedPlacement placement(object, mesh.box());
  std::vector<Eigen::Vector3f> out;
  out.reserve(mesh.vertices.size());
  for (const Vec3& p : mesh.vertices) {
    out.push_back(placement(p).cast<float>());
    if (!out.back().allFinite()) fail_range(object);
  }
  return out;
}

}  // namespace trivet
