#include "core/io/simulators/floor_corners.h"

#include <algorithm>

namespace trivet {
namespace {

constexpr double kNear = 1e-3;      // of the body's size
constexpr double kStraight = 1e-4;  // of an edge's length: its vertices are rounded

// Quarter of the directions; no two neighbours are farther apart than 27 degrees.
constexpr double kDirections[4][2] = {{1, 0}, {2, 1}, {1, 1}, {1, 2}};

std::vector<Vec3> world_vertices(const SimulationModel& model, const Pose& world_from_link) {
  const Affine world = world_from_object(world_from_link, UpAxis::Z, model.scale);
  std::vector<Vec3> out;
  for (const ConvexPart& part : model.parts)
    for (const Vec3& v : part.vertices) out.push_back(world.apply(v));
  return out;
}

std::vector<Vec3> low_vertices(const ConvexPart& part, const Affine& world, double reach) {
  std::vector<Vec3> out;
  for (const Vec3& v : part.vertices)
    if (const Vec3 p = world.apply(v); p.z() <= reach) out.push_back(p);
  return out;
}

const Vec3& farthest_from(const Vec3& from, const std::vector<Vec3>& points) {
  return *std::max_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
    return (a - from).squaredNorm() < (b - from).squaredNorm();
  });
}

/// The outer two of points on a line; none of one point, or of those that span a plane.
std::vector<Vec3> ends_of_line(const std::vector<Vec3>& points) {
  if (points.size() < 2) return {};
  const Vec3 a = farthest_from(points.front(), points), b = farthest_from(a, points);
  const double square = (b - a).squaredNorm();
  for (const Vec3& p : points)
    if ((p - a).cross(b - a).norm() > kStraight * square) return {};
  return square > 0 ? std::vector<Vec3>{a, b} : std::vector<Vec3>();
}

}  // namespace

std::vector<Vec3> floor_edge_ends(const SimulationModel& model, const Pose& world_from_link,
                                  double reach) {
  const Affine world = world_from_object(world_from_link, UpAxis::Z, model.scale);
  std::vector<Vec3> out;
  for (const ConvexPart& part : model.parts)
    for (const Vec3& end : ends_of_line(low_vertices(part, world, reach)))
      if (std::find(out.begin(), out.end(), end) == out.end()) out.push_back(end);
  return out;
}

std::vector<Vec3> floor_corners(const SimulationModel& model, const Pose& world_from_link) {
  std::vector<Vec3> near = world_vertices(model, world_from_link), out;
  if (near.empty()) return out;
  Aabb box;
  for (const Vec3& v : near) box.extend(v);
  const double lowest = box.lower.z(), reach = kNear * box.diagonal();
  if (lowest > reach) return out;
  std::erase_if(near, [&](const Vec3& v) { return v.z() > lowest + reach; });
  for (int quarter = 0; quarter < 4; ++quarter)
    for (const auto& [a, b] : kDirections) {
      const double x = quarter == 0 ? a : quarter == 1 ? -b : quarter == 2 ? -a : b;
      const double y = quarter == 0 ? b : quarter == 1 ? a : quarter == 2 ? -b : -a;
      const Vec3& farthest =
          *std::max_element(near.begin(), near.end(), [&](const Vec3& v, const Vec3& w) {
            return x * v.x() + y * v.y() < x * w.x() + y * w.y();
          });
      if (std::find(out.begin(), out.end(), farthest) == out.end()) out.push_back(farthest);
    }
  return out;
}

}  // namespace trivet
