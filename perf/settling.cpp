#include "perf/settling.h"

#include <Eigen/Dense>
#include <cmath>
#include <map>

#include "perf/scenes.h"

namespace trivet::perf {
namespace {

// Refinement before cutting, so that pieces follow the surface and not the faces.
constexpr int kPieceSplits = 4;

Mesh transformed(const Mesh& mesh, const Affine& m) {
  Mesh out = mesh;
  for (Vec3& v : out.vertices) v = m.apply(v);
  return out;
}

struct Solid {
  double volume = 0;
  Vec3 centre = Vec3::Zero();
  Mat3 second = Mat3::Zero();  // integral of x x^T about the centre
};

// Signed tetrahedra from the origin.
Solid solid_of(const Mesh& mesh) {
  Solid out;
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
    const Triangle t = mesh.triangle(f);
    const double volume = t[0].dot(t[1].cross(t[2])) / 6;
    const Vec3 sum = t[0] + t[1] + t[2];
    Mat3 products = sum * sum.transpose();
    for (const Vec3& p : t) products += p * p.transpose();
    out.volume += volume;
    out.centre += volume / 4 * sum;
    out.second += volume / 20 * products;
  }
  out.centre /= out.volume;
  out.second -= out.volume * out.centre * out.centre.transpose();
  return out;
}

bool is_flat(const Piece& piece) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : piece) mean += p / static_cast<double>(piece.size());
  Mat3 spread = Mat3::Zero();
  for (const Vec3& p : piece) spread += (p - mean) * (p - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvalues()[0] < 1e-9 * spread.trace();
}

// Clusters faces by their centre into columns over a square grid of the x-y plane; flat clusters
// join the previous one.
std::vector<Piece> pieces_of(const Mesh& coarse, double cell) {
  const Mesh mesh = refined(coarse, kPieceSplits);
  std::map<std::pair<long, long>, std::map<Index, Vec3>> columns;
  for (const Index3& t : mesh.triangles) {
    const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
    auto& column = columns[{std::lround(middle.x() / cell), std::lround(middle.y() / cell)}];
    for (const Index v : t) column.emplace(v, mesh.vertices[v]);
  }
  std::vector<Piece> out;
  for (const auto& [at, corners] : columns) {
    Piece piece;
    for (const auto& [id, p] : corners) piece.push_back(p);
    if (!out.empty() && (is_flat(piece) || is_flat(out.back())))
      out.back().insert(out.back().end(), piece.begin(), piece.end());
    else
      out.push_back(std::move(piece));
  }
  return out;
}

void transform(std::vector<Piece>* pieces, const Affine& m) {
  for (Piece& piece : *pieces)
    for (Vec3& p : piece) p = m.apply(p);
}

Pose inverse(const Pose& p) {
  const Rotation back{p.rotation.w, -p.rotation.x, -p.rotation.y, -p.rotation.z};
  return {back, -(back.matrix() * p.translation)};
}

Pose composed(const Pose& a, const Pose& b) {
  return {(a.rotation * b.rotation).normalized(),
          a.rotation.matrix() * b.translation + a.translation};
}

}  // namespace

Pose SettleTask::body_pose(const Pose& object) const { return composed(object, object_from_body); }

Pose SettleTask::object_pose(const Pose& body) const {
  return composed(body, inverse(object_from_body));
}

SettleTask make_task(const Object& moving, const Object& fixed, double density, double cell) {
  const Mesh upright =
      transformed(moving.shape->mesh, world_from_object(Pose{}, moving.up, moving.scale));
  const Solid solid = solid_of(upright);
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(solid.second);
  Mat3 axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);

  SettleTask task;
  task.object_from_body = {Rotation::from_matrix(axes), solid.centre};
  task.mass = density * solid.volume;
  const Vec3 squares = density * principal.eigenvalues();
  task.inertia = Vec3::Constant(squares.sum()) - squares;
  const Affine body_from_object = world_from_object(inverse(task.object_from_body), UpAxis::Z, 1);
  task.moving = transformed(upright, body_from_object);
  task.fixed = transformed(fixed.shape->mesh, fixed.world_from_object());
  task.moving_pieces = pieces_of(upright, cell);
  transform(&task.moving_pieces, body_from_object);
  task.fixed_pieces = pieces_of(task.fixed, cell);
  return task;
}

}  // namespace trivet::perf
