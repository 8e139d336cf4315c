#include "core/io/foreign/mass_sum.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace trivet {
namespace {

Mat3 diagonal(double x, double y, double z) { return Vec3(x, y, z).asDiagonal(); }

Mat3 outer(const Vec3& v) { return v * v.transpose(); }

/// Sums over the tetrahedra that the faces span with an apex, or over the faces alone.
SolidMoments integrate(const Mesh& mesh, const Vec3& apex, MeshMass rule) {
  double measure = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
    const Triangle t = mesh.triangle(f);
    const Vec3 a = t[0] - apex, b = t[1] - apex, c = t[2] - apex;
    const Vec3 sum = a + b + c;
    // A shell weighs by its faces, a solid by the tetrahedra from the apex to them.
    const bool shell = rule == MeshMass::Shell;
    double m = shell ? (b - a).cross(c - a).norm() / 2 : a.dot(b.cross(c)) / 6;
    // The legacy rule, which is the default of MuJoCo, counts all tetrahedra as positive.
    if (rule == MeshMass::Legacy) m = std::abs(m);
    measure += m;
    first += m / (shell ? 3 : 4) * sum;
    second += m / (shell ? 12 : 20) * (outer(a) + outer(b) + outer(c) + outer(sum));
  }
  SolidMoments out;
  out.volume = measure;
  if (!(std::abs(measure) > 0)) return out;
  // Products are moved from the apex to the centre.
  const Vec3 centre = first / measure;
  out.centre = apex + centre;
  out.spread = second / measure - outer(centre);
  return out;
}

}  // namespace

SolidMoments box_moments(const Vec3& half) {
  return {8 * half.prod(), Vec3::Zero(), half.cwiseAbs2().asDiagonal().toDenseMatrix() / 3};
}

SolidMoments ellipsoid_moments(const Vec3& radii) {
  return {4.0 / 3 * std::numbers::pi * radii.prod(), Vec3::Zero(),
          radii.cwiseAbs2().asDiagonal().toDenseMatrix() / 5};
}

SolidMoments cylinder_moments(double radius, double half) {
  const double across = radius * radius / 4;
  return {2 * std::numbers::pi * radius * radius * half, Vec3::Zero(),
          diagonal(across, across, half * half / 3)};
}

SolidMoments capsule_moments(double radius, double half) {
  const double r2 = radius * radius;
  // A capsule is a cylinder and two half balls, which are farther from the middle by their own
  // centres.
  const double middle = 2 * std::numbers::pi * r2 * half;
  const double caps = 4.0 / 3 * std::numbers::pi * r2 * radius;
  const double across = middle * r2 / 4 + caps * r2 / 5;
  const double along =
      middle * half * half / 3 + caps * (half * half + 2 * half * (3.0 / 8 * radius) + r2 / 5);
  const double all = middle + caps;
  return {all, Vec3::Zero(), diagonal(across / all, across / all, along / all)};
}

SolidMoments mesh_moments(const Mesh& mesh, MeshMass rule) {
  // The surface's centre is a better apex than the box's where tetrahedra count as positive.
  SolidMoments surface = integrate(mesh, mesh.box().centre(), MeshMass::Shell);
  if (rule == MeshMass::Shell) return surface;
  const SolidMoments once = integrate(mesh, surface.centre, rule);
  return rule == MeshMass::Legacy ? integrate(mesh, once.centre, rule) : once;
}

Mat3 inertia_of(const std::array<double, 6>& numbers) {
  const auto [xx, yy, zz, xy, xz, yz] = numbers;
  Mat3 out;
  out << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return out;
}

SolidMoments moments_of(const GivenMass& mass) {
  SolidMoments out;
  out.volume = 1;
  out.centre = mass.centre.value_or(Vec3::Zero());
  if (mass.inertia) {
    const Mat3 per_mass = *mass.inertia / mass.kilograms;
    // The spread is that of a unit mass: half the trace in each axis, less the inertia.
    out.spread = 0.5 * per_mass.trace() * Mat3::Identity() - per_mass;
  }
  return out;
}

void MassSum::add(double kilograms, const SolidMoments& part, const Pose& pose) {
  // Sums are about the origin: parts may come in any order.
  const Mat3 r = pose.rotation.matrix();
  const Vec3 centre = r * part.centre + pose.translation;
  m_kilograms += kilograms;
  m_first += kilograms * centre;
  m_second += kilograms * (r * part.spread * r.transpose() + outer(centre));
}

std::optional<GivenMass> MassSum::total() const {
  if (!(m_kilograms > 0)) return std::nullopt;
  const Vec3 centre = m_first / m_kilograms;
  const Mat3 spread = m_second / m_kilograms - outer(centre);
  GivenMass out{m_kilograms, centre, {}};
  // The inertia is about the common centre.
  const Mat3 inertia = m_kilograms * (spread.trace() * Mat3::Identity() - spread);
  out.inertia = 0.5 * (inertia + inertia.transpose());
  if (refuse_mass(out)) out.inertia.reset();  // flat or pointlike
  return out;
}

}  // namespace trivet
