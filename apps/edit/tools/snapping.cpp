#include "apps/edit/tools/snapping.h"

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "apps/edit/tools/picking.h"
#include "apps/edit/tools/typed_numbers.h"
#include "core/base/quoted.h"
#include "core/index/shape.h"

namespace trivet::edit {
namespace {

constexpr double kCrease = 0.93969262078590838;  // cos 20 degrees: flatter edges are none
constexpr double kInFrontPx = 0.5;               // of depth: nearer things hide a candidate
constexpr size_t kMostTried = 64;  // candidates of each kind that are looked at, nearest first

Vec3 unit_normal(const Triangle& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

/// True if the faces turn at the edge, or it is a border.
bool is_sharp(const Shape& shape, Index edge) {
  const auto wings = shape.adjacency.edge_faces[edge];
  if (wings.size() != 2) return true;
  const Vec3 a = unit_normal(shape.mesh.triangle(wings[0].face));
  const Vec3 b = unit_normal(shape.mesh.triangle(wings[1].face));
  // Faces that run through the edge the same way face opposite sides.
  const double cosine = wings[0].forward == wings[1].forward ? -a.dot(b) : a.dot(b);
  return cosine < kCrease;
}

struct Candidate {
  Snap snap;
  double px;  // from the pointer
};

/// Candidates of one object, each edge and corner once.
class Finder {
 public:
  Finder(const View& view, const Vec2& px, const SnapOptions& options, const ObjectSnapshot& object,
         std::vector<Candidate>& found)
      : m_view(view),
        m_ray(view.ray(px)),
        m_px(px),
        m_options(options),
        m_id(object.id),
        m_shape(*object->shape),
        m_world(object->world_from_object()),
        m_found(found) {}

  void find() {
    if (!m_shape.has_faces()) return;
    const Bvh& bvh = m_shape.bvh();
    std::array<Index, kMaxBvhDepth + 1> stack{};
    int depth = 1;
    while (depth > 0) {
      const BvhNode& node = bvh.nodes[stack[--depth]];
      if (is_far(node.box())) continue;
      if (!node.is_leaf()) {
        stack[depth++] = node.second_child;
        stack[depth++] = static_cast<Index>(&node - bvh.nodes.data()) + 1;
        continue;
      }
      for (Index i = 0; i < node.num_faces; ++i) add_face(bvh.faces[node.second_child + i]);
    }
    add_edges();
  }

 private:
  // No point of the box is seen within kSnapPx pixels of the pointer.
  bool is_far(const Aabb& box) const {
    const Vec3 centre = m_world.apply(box.centre());
    const double radius = (m_world.linear.cwiseAbs() * box.half_extent()).norm();
    const double farthest = m_view.depth(centre) + radius;
    if (!m_view.orthographic && !(farthest > 0)) return true;
    const Vec3 to = centre - m_ray.origin;
    const Vec3 aside = to - to.dot(m_ray.direction) * m_ray.direction;
    return aside.norm() > radius + (kSnapPx + 1) * m_view.metres_per_px(farthest);
  }

  void add_face(Index face) {
    for (const Index edge : m_shape.adjacency.face_edges[face])
      if (edge >= 0) m_edges.push_back(edge);
  }

  void add_edges() {
    std::sort(m_edges.begin(), m_edges.end());
    m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
    std::vector<Index> corners;
    for (const Index edge : m_edges) {
      if (!is_sharp(m_shape, edge)) continue;
      const auto& [a, b] = m_shape.adjacency.edge_vertices[edge];
      corners.insert(corners.end(), {a, b});
      if (m_options.edges) add_edge(at(a), at(b));
    }
    if (!m_options.corners) return;
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const Index vertex : corners) add(Snap::Kind::Corner, at(vertex));
  }

  Vec3 at(Index vertex) const { return m_world.apply(m_shape.mesh.vertices[vertex]); }

  // The place of the edge that is nearest to the pointer in the picture.
  void add_edge(const Vec3& a, const Vec3& b) {
    const auto pa = m_view.project(a), pb = m_view.project(b);
    if (!pa || !pb) return;
    const Vec2 along = *pb - *pa;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp(along.dot(m_px - *pa) / squared, 0.0, 1.0) : 0;
    add(Snap::Kind::Edge, on_segment(a, b, t));
  }

  /// The point of the segment that is seen at a part of its picture.
  Vec3 on_segment(const Vec3& a, const Vec3& b, double t) const {
    if (m_view.orthographic) return a + t * (b - a);
    const double wa = m_view.depth(a), wb = m_view.depth(b);
    return a + t * wa / (t * wa + (1 - t) * wb) * (b - a);
  }

  void add(Snap::Kind kind, const Vec3& point) {
    const auto seen = m_view.project(point);
    if (!seen || (m_view.cut && m_view.depth(point) < *m_view.cut)) return;
    const double px = (*seen - m_px).norm();
    if (px <= kSnapPx) m_found.push_back({{kind, point, m_id}, px});
  }

  const View& m_view;
  Ray m_ray;
  Vec2 m_px;
  const SnapOptions& m_options;
  ObjectId m_id;
  const Shape& m_shape;
  Affine m_world;
  std::vector<Candidate>& m_found;
  std::vector<Index> m_edges;
};

bool is_seen(const SceneSnapshot& scene, const View& view, const Vec3& point,
             const std::vector<ObjectId>& except) {
  const auto px = view.project(point);
  if (!px) return false;
  const auto hit = pick(scene, view.seen_ray(*px), except);
  const double depth = view.depth(point);
  return !hit || view.depth(hit->point) >= depth - kInFrontPx * view.metres_per_px(depth);
}

bool contains(const std::vector<ObjectId>& objects, ObjectId id) {
  return std::find(objects.begin(), objects.end(), id) != objects.end();
}

}  // namespace

std::optional<Snap> snap(const SceneSnapshot& scene, const View& view, const Vec2& px,
                         const SnapOptions& options, const std::vector<ObjectId>& except,
                         std::optional<ObjectId> only) {
  std::vector<Candidate> found;
  for (const ObjectSnapshot& object : scene.objects)
    if (object->placed && !contains(except, object.id) && (!only || object.id == *only))
      Finder(view, px, options, object, found).find();
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    if (a.snap.kind != b.snap.kind) return a.snap.kind < b.snap.kind;
    return a.px < b.px;
  });
  std::array<size_t, 2> tried{};  // corners, edges
  for (const Candidate& candidate : found)
    if (tried[static_cast<size_t>(candidate.snap.kind)]++ < kMostTried &&
        is_seen(scene, view, candidate.snap.point, except))
      return candidate.snap;
  if (!options.faces) return std::nullopt;
  const auto hit = pick(scene, view.seen_ray(px), except);
  if (!hit || (only && hit->object != only)) return std::nullopt;
  return Snap{Snap::Kind::Face, hit->point, hit->object};
}

double on_grid(double value, double step) {
  return step > 0 ? std::round(value / step) * step : value;
}

std::string in_words(const Snap& snap, const SceneSnapshot& scene) {
  const ObjectSnapshot* const object = snap.object ? scene.find(*snap.object) : nullptr;
  const QString of = object ? QString::fromStdString(quoted((*object)->name))
                            : QCoreApplication::translate("tools", "the floor");
  QString text = QCoreApplication::translate("tools", "face of %1");
  if (snap.kind == Snap::Kind::Corner) text = QCoreApplication::translate("tools", "corner of %1");
  if (snap.kind == Snap::Kind::Edge) text = QCoreApplication::translate("tools", "edge of %1");
  return (object ? text.arg(of) : of).toStdString();
}

std::string grid_in_words(double step) {
  return QCoreApplication::translate("tools", "grid %1 mm")
      .arg(QString::fromStdString(plain_number(1000 * step)))
      .toStdString();
}

}  // namespace trivet::edit
