#include "raster/zlist/layer.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "raster/zlist/angles.h"

namespace trivet {
namespace {

// A vertex is rounded to float32 once: half an ulp, with margin.
constexpr double kVertexError = 1.2e-7;

// An affine map, four rows at once.
class Map {
 public:
  explicit Map(const Affine& m) {
    for (int k = 0; k < 3; ++k) m_columns[k] << m.linear.col(k).array(), 0;
    m_columns[3] << m.translation.array(), 0;
  }
  Eigen::Array4d operator()(const Vec3& p) const {
    return p.x() * m_columns[0] + p.y() * m_columns[1] + (p.z() * m_columns[2] + m_columns[3]);
  }

 private:
  std::array<Eigen::Array4d, 4> m_columns;
};

ImageVertex turning(const Eigen::Array4d& p, double first_radius, double low) {
  // The image of a rotation has radius, height and, as depth, the angle.
  const double angle = wrapped(fast_atan2(p.y(), p.x()), low);
  return {static_cast<float>(std::sqrt(p.x() * p.x() + p.y() * p.y()) - first_radius),
          static_cast<float>(p.z()), static_cast<float>(angle), 0};
}

}  // namespace

Layer::Layer(const ZListFrame& frame, std::span<const Body> bodies, std::span<const Index> chosen)
    : m_frame(frame) {
  // Faces of all bodies are numbered in one row.
  for (const Index b : chosen) {
    m_members.push_back({b, &bodies[b], frame.pixels_from_object(bodies[b]), m_num_faces, {}});
    m_num_faces += static_cast<std::uint32_t>(bodies[b].shape->mesh.triangles.size());
  }
}

void Layer::project(int num_threads) {
  const bool is_turn = m_frame.kind == Motion::Kind::Rotation;
  // Angles are cut open opposite to the middle of the moving bodies.
  const double low = m_frame.moving_depth / 2 - kPi;
  for (Member& m : m_members) {
    const std::vector<Vec3>& from = m.source->shape->mesh.vertices;
    m.vertices.resize(from.size());
    std::vector<ImageVertex> largest(num_parts(from.size(), num_threads), ImageVertex::Zero());
    // Parts keep their own maxima, which are joined in order.
    for_each_part(from.size(), num_threads, [&](size_t part, size_t first, size_t last) {
      ImageVertex high = ImageVertex::Zero();
      const Map map(m.pixels_from_object);
      for (size_t i = first; i < last; ++i) {
        const Eigen::Array4d p = map(from[i]);
        m.vertices[i] = is_turn ? turning(p, m_frame.first_radius, low) : p.cast<float>();
        high = high.max(m.vertices[i].abs());
      }
      largest[part] = high;
    });
    ImageVertex high = ImageVertex::Zero();
    for (const ImageVertex& x : largest) high = high.max(x);
    // Rounding of vertices is covered by drawing each face this much larger.
    m.position_error = kVertexError * std::max(high[0], high[1]);
    m.depth_error = kVertexError * high[2] + (is_turn ? kAngleError : 0);
  }
}

const Layer::Member& Layer::member_of(std::uint32_t face) const {
  // The body whose first face is the last one not above this face holds it.
  const auto after = [](std::uint32_t f, const Member& m) { return f < m.first_face; };
  return *(std::upper_bound(m_members.begin(), m_members.end(), face, after) - 1);
}

Layer::FaceId Layer::id(std::uint32_t face) const {
  const Member& m = member_of(face);
  return {m.body, static_cast<Index>(face - m.first_face)};
}

Triangle Layer::corners(std::uint32_t face) const {
  const Member& m = member_of(face);
  const Mesh& mesh = m.source->shape->mesh;
  const Index3& t = mesh.triangles[face - m.first_face];
  return {m.pixels_from_object.apply(mesh.vertices[t[0]]),
          m.pixels_from_object.apply(mesh.vertices[t[1]]),
          m.pixels_from_object.apply(mesh.vertices[t[2]])};
}

}  // namespace trivet
