// Energy of contact: stiffness x mollifier(c) x barrier(gap), and its exact second derivative. The
// distance is the least of |d(x, q)| over the free parameters q of the closest points, so that
//   D2 distance = f_xx - f_xq f_qq^-1 f_qx
// with f_xx = W' (I - n n') W / l, f_xq = dW/dq n + W d_q / l, f_qq = d_q . d_q' / l.
#include <Eigen/Geometry>

#include "core/flex/barrier.h"
#include "core/flex/contact.h"

namespace trivet::flex {
namespace {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

constexpr double kSingular = 1e-8;  // of a determinant over the product of its diagonal

void add_outer(Mat12& out, const Vec12& a, const Vec12& b, double factor) {
  for (int c = 0; c < 12; ++c)
    for (int r = 0; r < 12; ++r) out(r, c) += factor * a[r] * b[c];
}

Vec12 distance_gradient(const PairPoints& p, const Vec3& n) {
  Vec12 out = Vec12::Zero();
  for (int i = 0; i < p.count; ++i) out.segment<3>(3 * i) = p.weights[i] * n;
  return out;
}

// Takes away what the free parameters give way.
void relax(const PairPoints& p, const Vec3& n, Mat12& out) {
  // The mixed derivatives tell how the points slide along the elements as the vertices move.
  Vec12 mixed[2] = {Vec12::Zero(), Vec12::Zero()};
  for (int q = 0; q < p.num_free; ++q)
    for (int i = 0; i < p.count; ++i)
      mixed[q].segment<3>(3 * i) =
          p.weight_slope[q][i] * n + p.weights[i] / p.distance * p.slope[q];
  const double l = p.distance;
  const double aa = p.num_free > 0 ? p.slope[0].squaredNorm() / l : 0;
  const double bb = p.num_free > 1 ? p.slope[1].squaredNorm() / l : 0;
  const double ab = p.num_free > 1 ? p.slope[0].dot(p.slope[1]) / l : 0;
  // Two free parameters need the inverse of a symmetric matrix of two rows; nearly singular ones
  // count as one.
  const double determinant = aa * bb - ab * ab;
  if (p.num_free == 2 && determinant > kSingular * aa * bb) {
    add_outer(out, mixed[0], mixed[0], -bb / determinant);
    add_outer(out, mixed[1], mixed[1], -aa / determinant);
    add_outer(out, mixed[0], mixed[1], ab / determinant);
    add_outer(out, mixed[1], mixed[0], ab / determinant);
  } else if (aa > 0) {
    add_outer(out, mixed[0], mixed[0], -1 / aa);
  }
}

Mat12 distance_curvature(const PairPoints& p, const Vec3& n) {
  Mat12 out = Mat12::Zero();
  // The distance bends across the direction alone.
  const Mat3 across = (Mat3::Identity() - outer(n, n)) / p.distance;
  for (int i = 0; i < p.count; ++i)
    for (int j = 0; j < p.count; ++j)
      out.block<3, 3>(3 * i, 3 * j) = across * (p.weights[i] * p.weights[j]);
  relax(p, n, out);
  return out;
}

// Derivatives of c = |a x b|^2 by the four ends; of an obstacle's edge by none.
struct CrossSquare {
  Vec12 gradient = Vec12::Zero();
  Mat12 curvature = Mat12::Zero();

  CrossSquare(const PairPoints& p, bool is_own) {
    const Vec3 &a = p.edge_a, &b = p.edge_b;
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b);
    // The gradient of |a x b|^2 by an edge is twice the other edge's square times it, less their
    // product.
    put(0, 2 * (bb * a - ab * b));
    put(0, 0, 2 * (bb * Mat3::Identity() - outer(b, b)));
    if (!is_own) return;
    put(2, 2 * (aa * b - ab * a));
    put(2, 2, 2 * (aa * Mat3::Identity() - outer(a, a)));
    const Mat3 mixed = 4 * outer(a, b) - 2 * ab * Mat3::Identity() - 2 * outer(b, a);
    put(0, 2, mixed);
    put(2, 0, mixed.transpose());
  }

 private:
  void put(int end, const Vec3& of_edge) {
    gradient.segment<3>(3 * end) = -of_edge;
    gradient.segment<3>(3 * end + 3) = of_edge;
  }
  void put(int i, int j, const Mat3& of_edges) {
    for (int u = 0; u < 2; ++u)
      for (int v = 0; v < 2; ++v)
        curvature.block<3, 3>(3 * (i + u), 3 * (j + v)) = u == v ? of_edges : Mat3(-of_edges);
  }
};

// The Jacobian of a x b by the end `end`, times its transpose by the end `other`: what is positive
// of the mollifier's curvature.
Mat3 turned(const PairPoints& p, int end, int other) {
  // The derivative of a x b by an end is the cross product with the other edge, as a matrix.
  const auto by = [&](int k) {
    const Vec3 e = k < 2 ? Vec3(-p.edge_b) : p.edge_a;
    Mat3 m;
    m << 0, -e[2], e[1], e[2], 0, -e[0], -e[1], e[0], 0;
    return Mat3(k % 2 == 1 ? m : Mat3(-m));
  };
  const Mat3 a = by(end), b = by(other);
  Mat3 out = Mat3::Zero();
  for (int k = 0; k < 3; ++k) out += outer(a.row(k), b.row(k));
  return out;
}

void add_positive(const ContactPair& pair, const Barrier& barrier, const Total& total) {
  const PairPoints& p = pair.points;
  // The barrier is convex along the normal; what it adds across the normal is negative, and left
  // out.
  const Vec3 n = p.direction();
  const Mat3 along = outer(n, n) * (pair.stiffness * pair.mollifier.value * barrier.second);
  for (int i = 0; i < p.count; ++i)
    for (int j = 0; j < p.count; ++j)
      total.add(p.vertices[i], p.vertices[j], along * (p.weights[i] * p.weights[j]));
  // A whole mollifier has no derivatives.
  if (pair.mollifier.value == 1) return;
  const double factor = 2 * pair.stiffness * barrier.value * pair.mollifier.first;
  for (int i = 0; i < p.count; ++i)
    for (int j = 0; j < p.count; ++j)
      total.add(p.vertices[i], p.vertices[j], turned(p, i, j) * factor);
}

void add_exact(const ContactPair& pair, const Barrier& barrier, const Total& total) {
  const PairPoints& p = pair.points;
  const Mollifier& m = pair.mollifier;
  // The chain rule over distance and mollifier gives all second derivatives, signs included.
  const Vec3 n = p.direction();
  const Vec12 slope = distance_gradient(p, n);
  Mat12 all = distance_curvature(p, n) * (m.value * barrier.first);
  add_outer(all, slope, slope, m.value * barrier.second);
  if (m.value != 1) {
    const CrossSquare c(p, pair.pair.is_own());
    add_outer(all, c.gradient, slope, barrier.first * m.first);
    add_outer(all, slope, c.gradient, barrier.first * m.first);
    add_outer(all, c.gradient, c.gradient, barrier.value * m.second);
    all += c.curvature * (barrier.value * m.first);
  }
  for (int i = 0; i < p.count; ++i)
    for (int j = 0; j < p.count; ++j)
      total.add(p.vertices[i], p.vertices[j], all.block<3, 3>(3 * i, 3 * j) * pair.stiffness);
}

void add_gradient(const ContactPair& pair, const Barrier& barrier, const Total& total) {
  const PairPoints& p = pair.points;
  const Vec3 push = pair.stiffness * pair.mollifier.value * barrier.first * p.direction();
  for (int i = 0; i < p.count; ++i) total.add(p.vertices[i], p.weights[i] * push);
  if (pair.mollifier.value == 1) return;
  const CrossSquare c(p, pair.pair.is_own());
  const double factor = pair.stiffness * barrier.value * pair.mollifier.first;
  for (int i = 0; i < p.count; ++i) total.add(p.vertices[i], factor * c.gradient.segment<3>(3 * i));
}

}  // namespace

double Contact::energy(const std::vector<ContactPair>& pairs, const Total& total) {
  double sum = 0;
  for (const ContactPair& pair : pairs) {
    const auto& vertices = pair.points.vertices;
    if (!total.has_any(vertices, pair.points.count)) continue;
    const Barrier barrier(pair.gap, pair.layer);
    // Inside the layer each pair adds its barrier; a pair at the border adds nothing.
    sum += total.energy_of(vertices[0], pair.stiffness * pair.mollifier.value * barrier.value);
    if (total.gradient) add_gradient(pair, barrier, total);
    if (!total.hessian) continue;
    if (total.curvature == Curvature::Positive)
      add_positive(pair, barrier, total);
    else
      add_exact(pair, barrier, total);
  }
  return sum;
}

}  // namespace trivet::flex
