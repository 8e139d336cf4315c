#include "core/flex/elasticity.h"

#include <algorithm>
#include <cmath>

#include "core/flex/hinges.h"

namespace trivet::flex {
namespace {

double weigh(const Body& body, const Points& x, const Total& total) {
  double sum = 0;
  const int last = std::min(total.last, static_cast<int>(x.size()));
  for (int v = total.first; v < last; ++v) {
    const double weight = body.mass[v] * kGravity;
    sum += weight * x[v][2];
    total.add(v, {0, 0, weight});
  }
  return sum;
}

/// Stress along warp and weft, and shear: N/m.
struct Stress {
  double u, v, shear;

  /// Without compression: its positive part.
  Stress tension() const {
    // Principal stresses follow from the circle through both directions and the shear.
    const double middle = (u + v) / 2, half = (u - v) / 2;
    const double radius = std::sqrt(half * half + shear * shear);
    const double largest = middle + radius;
    // Compression is left out, as the matrix stays positive definite with tension alone.
    if (middle - radius >= 0) return *this;
    if (largest <= 0) return {0, 0, 0};
    // The projection keeps the part along the tensile principal direction.
    const double cosine = radius > 0 ? half / radius : 1, sine = radius > 0 ? shear / radius : 0;
    return {largest * (1 + cosine) / 2, largest * (1 - cosine) / 2, largest * sine / 2};
  }
};

/// One face: its deformed warp and weft.
class StretchedFace {
 public:
  StretchedFace(const Membrane& m, const FlexMaterial& material, const Points& x)
      : m_face(m), m_material(material) {
    // The deformed warp and weft are sums over the corners by the rest shape's gradients.
    for (int k = 0; k < 3; ++k) {
      m_u += m.gradient[k][0] * x[m.corners[k]];
      m_v += m.gradient[k][1] * x[m.corners[k]];
    }
    // Green's strain is zero under any rotation, so that turning costs nothing.
    m_strain = {(m_u.squaredNorm() - 1) / 2, (m_v.squaredNorm() - 1) / 2, m_u.dot(m_v)};
    m_stress = {material.stretch * m_strain.u + material.coupling * m_strain.v,
                material.stretch * m_strain.v + material.coupling * m_strain.u,
                material.shear * m_strain.shear};
  }
  double stretch() const { return std::sqrt(std::max(m_u.squaredNorm(), m_v.squaredNorm())); }
  double energy() const {
    return m_face.area / 2 *
           (m_strain.u * m_stress.u + m_strain.v * m_stress.v + m_strain.shear * m_stress.shear);
  }
  void add_gradient(const Total& total) const {
    const Vec3 along = m_u * m_stress.u + m_v * m_stress.shear;
    const Vec3 across = m_v * m_stress.v + m_u * m_stress.shear;
    for (int k = 0; k < 3; ++k)
      total.add(m_face.corners[k],
                m_face.area * (along * m_face.gradient[k][0] + across * m_face.gradient[k][1]));
  }
  // B' C B, and the stress on the diagonal.
  void add_curvature(const Total& total) const {
    const Stress stress = total.curvature == Curvature::Exact ? m_stress : m_stress.tension();
    // The matrix is symmetric: each pair of corners is computed once.
    for (int a = 0; a < 3; ++a)
      for (int b = a; b < 3; ++b) {
        Mat3 block = stiff_block(a, b);
        block.diagonal().array() += stress_term(stress, a, b);
        block *= m_face.area;
        if (a == b)
          total.add(m_face.corners[a], m_face.corners[a], block);
        else
          total.add_both(m_face.corners[a], m_face.corners[b], block);
      }
  }

 private:
  double stress_term(const Stress& s, int a, int b) const {
    const auto& g = m_face.gradient;
    return g[a][0] * (s.u * g[b][0] + s.shear * g[b][1]) +
           g[a][1] * (s.shear * g[b][0] + s.v * g[b][1]);
  }
  Mat3 stiff_block(int a, int b) const {
    const auto& g = m_face.gradient;
    const Vec3 u_a = g[a][0] * m_u, v_a = g[a][1] * m_v, s_a = g[a][1] * m_u + g[a][0] * m_v;
    const Vec3 u_b = g[b][0] * m_u, v_b = g[b][1] * m_v, s_b = g[b][1] * m_u + g[b][0] * m_v;
    Mat3 out = outer(u_a, m_material.stretch * u_b + m_material.coupling * v_b);
    out += outer(v_a, m_material.stretch * v_b + m_material.coupling * u_b);
    out += outer(s_a, m_material.shear * s_b);
    return out;
  }

  const Membrane& m_face;
  const FlexMaterial& m_material;
  Vec3 m_u = Vec3::Zero(), m_v = Vec3::Zero();
  Stress m_strain{}, m_stress{};
};

double stretch_faces(const Body& body, const Points& x, const Total& total) {
  double sum = 0;
  for (const Membrane& m : body.membranes) {
    if (!total.has_any(m.corners, 3)) continue;
    const StretchedFace face(m, body.material, x);
    sum += total.energy_of(m.corners[0], face.energy());
    if (total.gradient) face.add_gradient(total);
    if (total.hessian) face.add_curvature(total);
  }
  return sum;
}

double bend(const Body& body, const Points& x, const Total& total) {
  double sum = 0;
  for (const Stencil& s : body.stencils) {
    if (!total.has_any(s.vertices, s.count)) continue;
    // Bending is quadratic in the positions: its second derivative is constant.
    Vec3 bent = Vec3::Zero();
    for (int k = 0; k < s.count; ++k) bent += s.factors[k] * x[s.vertices[k]];
    sum += total.energy_of(s.vertices[0], s.stiffness * bent.squaredNorm() / 2);
    for (int k = 0; total.gradient && k < s.count; ++k)
      total.add(s.vertices[k], s.stiffness * s.factors[k] * bent);
    for (int a = 0; total.hessian && a < s.count; ++a)
      for (int b = 0; b < s.count; ++b)
        total.add(s.vertices[a], s.vertices[b],
                  Mat3::Identity() * (s.stiffness * s.factors[a] * s.factors[b]));
  }
  return sum;
}

void add_spring(const Spring& s, const Vec3& along, double length, const Total& total) {
  const Vec3 force = s.stiffness * (length - s.rest) * along;
  total.add(s.b, force);
  total.add(s.a, -force);
  if (!total.hessian) return;
  // A compressed spring pushes sideways; without that part the matrix stays positive definite.
  double across = 1 - s.rest / length;
  if (total.curvature != Curvature::Exact) across = std::max(0.0, across);
  const Mat3 direction = outer(along, along);
  const Mat3 block = s.stiffness * (direction + across * (Mat3::Identity() - direction));
  total.add(s.a, s.a, block);
  total.add(s.b, s.b, block);
  total.add_both(s.a, s.b, -block);
}

double pull(const Body& body, const Points& x, const Total& total) {
  double sum = 0;
  for (const Spring& s : body.springs) {
    if (!total.has(s.a) && !total.has(s.b)) continue;
    const Vec3 along = x[s.b] - x[s.a];
    const double length = along.norm();
    sum += total.energy_of(s.a, s.stiffness * (length - s.rest) * (length - s.rest) / 2);
    add_spring(s, along / length, length, total);
  }
  return sum;
}

}  // namespace

double elastic_energy(const Body& body, const Points& x, Total& total) {
  double sum = weigh(body, x, total);
  sum += stretch_faces(body, x, total);
  sum += bend(body, x, total);
  sum += pull(body, x, total);
  sum += bend_hinges(body, x, total);
  return sum;
}

double largest_stretch(const Body& body, const Points& x) {
  double largest = 0;
  for (const Membrane& m : body.membranes)
    largest = std::max(largest, StretchedFace(m, body.material, x).stretch());
  for (const Spring& s : body.springs)
    largest = std::max(largest, (x[s.b] - x[s.a]).norm() / s.rest);
  return largest;
}

}  // namespace trivet::flex
