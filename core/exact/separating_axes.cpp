#include "core/exact/separating_axes.h"

#include <Eigen/Geometry>

namespace trivet {
namespace {

// A world coordinate of a point is rounded 4 times on its way from the object frame; the
// projections of the frame, of centre and half extent of the box, and their sums, less than 28
// times in all. Each is at most half an ulp of the sum of the magnitudes.
constexpr double kBoxRounding = 64 * 0x1p-53;

}  // namespace

SeparatingAxes::SeparatingAxes(const BoxFrame& a, const BoxFrame& b) {
  set_frames(a, b);
  add_face_normals(a.world_from_object.linear, a, b);
  add_face_normals(b.world_from_object.linear, a, b);
}

SeparatingAxes SeparatingAxes::of_segment(const BoxFrame& a, const BoxFrame& b) {
  // A segment has one direction: beside the box's faces only its crosses with the box's edges can
  // separate.
  SeparatingAxes out;
  out.set_frames(a, b);
  const Mat3& linear = b.world_from_object.linear;
  out.add_face_normals(linear, a, b);
  for (int k = 0; k < 3; ++k) out.add(a.world_from_object.linear.col(0).cross(linear.col(k)), a, b);
  return out;
}

void SeparatingAxes::set_frames(const BoxFrame& a, const BoxFrame& b) {
  m_scale_a = a.world_from_object.linear.colwise().norm().maxCoeff();
  m_scale_b = b.world_from_object.linear.colwise().norm().maxCoeff();
}

void SeparatingAxes::add_face_normals(const Mat3& linear, const BoxFrame& a, const BoxFrame& b) {
  for (int k = 0; k < 3; ++k) add(linear.col((k + 1) % 3).cross(linear.col((k + 2) % 3)), a, b);
}

void SeparatingAxes::add(const Vec3& direction, const BoxFrame& a, const BoxFrame& b) {
  const Vec3 n = direction.stableNormalized();
  if (!(n.squaredNorm() > 0.5)) return;  // no direction
  const auto magnitude = [&](const BoxFrame& f) {
    const Affine& w = f.world_from_object;
    return n.cwiseAbs().dot(w.linear.cwiseAbs() * f.reach + w.translation.cwiseAbs());
  };
  Axis& axis = m_axes[m_num_axes++];
  // Boxes stay in their own frames; the axis is turned into each of them.
  axis.of_a = a.world_from_object.linear.transpose() * n;
  axis.of_b = b.world_from_object.linear.transpose() * n;
  axis.offset = n.dot(b.world_from_object.translation - a.world_from_object.translation);
  // The margin covers slack and rounding: boxes may only be called apart if they are.
  axis.margin =
      (1 + kBoxRounding) * (a.slack + b.slack) + kBoxRounding * (magnitude(a) + magnitude(b));
}

bool SeparatingAxes::separate(const Aabb& box_a, const Aabb& box_b) const {
  const Vec3 centre_a = box_a.centre(), half_a = box_a.half_extent();
  const Vec3 centre_b = box_b.centre(), half_b = box_b.half_extent();
  for (int i = 0; i < m_num_axes; ++i) {
    const Axis& axis = m_axes[i];
    // The boxes are apart along an axis if their centres are further than both half extents reach.
    const double distance =
        std::abs(axis.of_b.dot(centre_b) - axis.of_a.dot(centre_a) + axis.offset);
    const double reach = axis.of_a.cwiseAbs().dot(half_a) + axis.of_b.cwiseAbs().dot(half_b);
    if (distance > reach + axis.margin) return true;
  }
  return false;
}

SeparatingAxes::AlongAxes SeparatingAxes::of_a(const Aabb& box) const {
  AlongAxes out;
  const Vec3 centre = box.centre(), half = box.half_extent();
  for (int i = 0; i < m_num_axes; ++i) {
    out.centre[i] = m_axes[i].of_a.dot(centre);
    out.reach[i] = m_axes[i].of_a.cwiseAbs().dot(half);
  }
  return out;
}

SeparatingAxes::AlongAxes SeparatingAxes::of_b(const Aabb& box) const {
  AlongAxes out;
  const Vec3 centre = box.centre(), half = box.half_extent();
  for (int i = 0; i < m_num_axes; ++i) {
    out.centre[i] = m_axes[i].of_b.dot(centre);
    out.reach[i] = m_axes[i].of_b.cwiseAbs().dot(half);
  }
  return out;
}

bool SeparatingAxes::separate(const AlongAxes& a, const AlongAxes& b) const {
  for (int i = 0; i < m_num_axes; ++i)
    if (std::abs(b.centre[i] - a.centre[i] + m_axes[i].offset) >
        a.reach[i] + b.reach[i] + m_axes[i].margin)
      return true;
  return false;
}

bool SeparatingAxes::a_is_larger(const Aabb& box_a, const Aabb& box_b) const {
  return m_scale_a * (box_a.upper - box_a.lower).sum() >
         m_scale_b * (box_b.upper - box_b.lower).sum();
}

}  // namespace trivet
