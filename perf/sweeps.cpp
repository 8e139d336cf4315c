#include "perf/sweeps.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "core/base/tunables.h"

namespace trivet::perf {
namespace {

constexpr double kBump = 0.15;

struct Grid {
  int num_triangles, rings, segments;  // 2 x segments x (rings - 1) triangles
};
constexpr std::array<Grid, 7> kGrids{{{1'000, 21, 25},
                                      {10'000, 41, 125},
                                      {15'000, 51, 150},
                                      {100'000, 126, 400},
                                      {150'000, 151, 500},
                                      {1'000'000, 401, 1250},
                                      {1'500'000, 501, 1500}}};

Clearance clearance_of(const Sweep& sweep) {
  Aabb box = sweep.moving().world_box;
  box.extend(sweep.fixed().world_box);
  return {kRelativeClearance * box.diagonal()};
}

Body body_of(const Shape& shape, const Pose& pose) {
  return {shape, world_from_object(pose, UpAxis::Z, 1)};
}

}  // namespace

Mesh make_sphere_mesh(int num_triangles, unsigned seed) {
  for (const Grid& grid : kGrids)
    if (grid.num_triangles == num_triangles)
      return weld(test::bumpy_sphere(grid.rings, grid.segments, kBump, seed));
  throw std::invalid_argument("no sphere of " + std::to_string(num_triangles) + " triangles");
}

SpherePair make_sphere_pair(int num_triangles) {
  SpherePair out{num_triangles, make_shape(make_sphere_mesh(num_triangles, 1)),
                 make_shape(make_sphere_mesh(num_triangles, 2))};
  for (const Shape* shape : {out.moving.get(), out.fixed.get()}) shape->bvh();
  return out;
}

Body Sweep::moving() const { return body_of(*spheres->moving, pose_moving); }
Body Sweep::fixed() const { return body_of(*spheres->fixed, pose_fixed); }

FirstContact Sweep::first_contact() const {
  const Body a = moving(), b = fixed();
  FirstContactQuery query;
  query.moving = {&a, 1};
  query.fixed = {&b, 1};
  query.motion = motion;
  query.clearance = clearance;
  return trivet::first_contact(query);
}

double Sweep::travel(double time) const {
  if (motion.kind == Motion::Kind::Translation) return time;
  const Vec3 arm = pose_moving.translation - motion.centre;
  return 2 * std::atan(time) * (arm - motion.axis.dot(arm) * motion.axis).norm();
}

double Sweep::time_at(double part) const {
  if (motion.kind == Motion::Kind::Translation) return part * motion.limit;
  return std::tan(part * std::atan(motion.limit));
}

Sweep random_drop(const SpherePair& spheres, test::Random& random) {
  Sweep out{&spheres, {}, {}, Motion::translation(-Vec3::UnitZ(), 3), {}};
  out.pose_moving = {random.rotation(),
                     {random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), 2.6}};
  out.pose_fixed = {random.rotation(), Vec3::Zero()};
  out.clearance = clearance_of(out);
  return out;
}

Sweep random_turn(const SpherePair& spheres, test::Random& random) {
  const Vec3 axis = random.direction();
  const Vec3 beside = axis.cross(random.direction()).normalized();
  const Vec3 centre = random.uniform(2, 2.4) * beside;
  // Turned back from the middle by 75 to 85 degrees: s = tan of half the angle.
  const Rotation back = Rotation::about_axis(-axis, random.uniform(0.77, 0.91));
  const Vec3 off = random.uniform(-0.5, 0.5) * axis;
  Sweep out{&spheres, {}, {}, Motion::rotation(centre, axis, 1), {}};
  out.pose_moving = {random.rotation(), centre + back.matrix() * -centre + off};
  out.pose_fixed = {random.rotation(), Vec3::Zero()};
  out.clearance = clearance_of(out);
  return out;
}

}  // namespace trivet::perf
