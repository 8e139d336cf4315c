#include "core/mesh/hull.h"

#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/error.h"

namespace trivet {
namespace {

constexpr int kDimension = 3;

/// One run of Qhull with its memory. Its messages go to a discarded buffer: they concern flat
/// input, which is not an error here.
class QhullRun {
 public:
  QhullRun() : m_messages(fmemopen(m_buffer.data(), m_buffer.size(), "w")) {
    if (!m_messages)
      throw Error(Error::Kind::Environment, "cannot allocate a stream for Qhull's messages");
    qh_zero(&m_qhull, m_messages);
  }
  ~QhullRun() {
    int bytes_left = 0, blocks_left = 0;
    qh_freeqhull(&m_qhull, !qh_ALL);  // its long memory
    qh_memfreeshort(&m_qhull, &bytes_left, &blocks_left);
    std::fclose(m_messages);
  }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;

  /// Returns whether the points have a solid hull.
  bool compute(std::vector<double>& coordinates) {
    // Points on a plane or a line are refused by Qhull, not by a throw: the caller takes another
    // way.
    char command[] = "qhull Qt Pp";  // triangles only; no warnings about precision
    const int num_points = static_cast<int>(coordinates.size()) / kDimension;
    return qh_new_qhull(&m_qhull, kDimension, num_points, coordinates.data(), False, command,
                        nullptr, m_messages) == qh_ERRnone;
  }

  std::vector<Index3> triangles() {
    std::vector<Index3> out;
    for (facetT* facet = m_qhull.facet_list; facet && facet->next; facet = facet->next) {
      // Facets that are not triangles have no place in a triangulated hull.
      if (qh_setsize(&m_qhull, facet->vertices) != kDimension) continue;
      Index3& triangle = out.emplace_back();
      for (int k = 0; k < kDimension; ++k) {
        const auto* vertex = static_cast<vertexT*>(facet->vertices->e[k].p);
        triangle[k] = qh_pointid(&m_qhull, vertex->point);
      }
    }
    return out;
  }

 private:
  std::array<char, 1024> m_buffer{};
  std::FILE* m_messages;
  qhT m_qhull;
};

/// Coordinates relative to the box's centre, scaled by a power of two to about 1, so that neither
/// an offset nor the unit costs digits.
std::vector<double> normalised(std::span<const Vec3> points) {
  Aabb box;
  for (const Vec3& p : points) box.extend(p);
  const Vec3 centre = box.centre();
  int exponent = 0;
  std::frexp(box.half_extent().maxCoeff(), &exponent);
  std::vector<double> out;
  out.reserve(kDimension * points.size());
  for (const Vec3& p : points)
    for (int axis = 0; axis < kDimension; ++axis)
      out.push_back(std::ldexp(p[axis] - centre[axis], -exponent));
  return out;
}

}  // namespace

ConvexHull convex_hull(std::span<const Vec3> points) {
  ConvexHull hull;
  // Fewer than four points enclose nothing.
  if (points.size() < kDimension + 1) return hull;
  std::vector<double> coordinates = normalised(points);
  QhullRun run;
  if (!run.compute(coordinates)) return hull;
  hull.triangles = run.triangles();
  // The vertices are those that triangles name, each once.
  for (const Index3& t : hull.triangles)
    hull.vertices.insert(hull.vertices.end(), t.begin(), t.end());
  std::sort(hull.vertices.begin(), hull.vertices.end());
  hull.vertices.erase(std::unique(hull.vertices.begin(), hull.vertices.end()), hull.vertices.end());
  return hull;
}

}  // namespace trivet
