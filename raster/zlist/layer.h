// The faces of several bodies in the coordinates of a frame.
#pragma once

#include <span>
#include <vector>

#include "core/candidates/zlist_frame.h"

namespace trivet {

/// A vertex in float32: (column, row, depth), the depth of a turn in [moving_depth / 2 - pi,
/// moving_depth / 2 + pi). Filled up to 16 bytes, one register.
using ImageVertex = Eigen::Array4f;

/// Faces of several bodies, numbered consecutively.
class Layer {
 public:
  struct Member {
    Index body;  // index into the query's span
    const Body* source;
    Affine pixels_from_object;
    std::uint32_t first_face;
    std::vector<ImageVertex> vertices;  // empty before project()
    double position_error = 0;          // pixels, of the vertices
    double depth_error = 0;
  };
  struct FaceId {
    Index body, face;
  };

  Layer(const ZListFrame& frame, std::span<const Body> bodies, std::span<const Index> chosen);

  /// Computes the vertices in float32. Cost O(vertices); on `num_threads` threads.
  void project(int num_threads);

  const std::vector<Member>& members() const { return m_members; }
  std::uint32_t num_faces() const { return m_num_faces; }
  FaceId id(std::uint32_t face) const;
  /// In double, as from ZListFrame::pixels_from_object().
  Triangle corners(std::uint32_t face) const;

 private:
  const Member& member_of(std::uint32_t face) const;

  const ZListFrame& m_frame;
  std::vector<Member> m_members;
  std::uint32_t m_num_faces = 0;
};

}  // namespace trivet
