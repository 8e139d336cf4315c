#include "ops/mend/columns.h"

#include <Eigen/Geometry>
#include <cmath>

#include "raster/zlist/line_faces.h"

namespace trivet {
namespace {

constexpr double kReachBelow = 5;  // tolerances below an object, in which others count

/// Others that a column of the object may meet near it.
std::vector<size_t> near_ones(const std::vector<Body>& bodies, size_t object, double tolerance) {
  Aabb box = bodies[object].world_box;
  // The reach below the object finds supports from which noise has lifted it.
  box.lower.z() -= kReachBelow * tolerance + 0.02;
  box.upper.z() += tolerance;
  std::vector<size_t> out;
  for (size_t i = 0; i < bodies.size(); ++i)
    if (i != object && overlaps(box, bodies[i].world_box)) out.push_back(i);
  return out;
}

/// Takes the faces on every line of sight down through the object.
class ColumnReader {
 public:
  /// The body of index 0 is the object, and its faces come first.
  ColumnReader(const std::vector<Body>& bodies, const std::vector<bool>& is_solid,
               const Projection& projection, double tolerance)
      : m_bodies(bodies),
        m_is_solid(is_solid),
        m_projection(projection),
        m_tolerance(tolerance),
        m_columns(size_t(projection.width) * projection.height,
                  Column{Vec2::Zero(), kInfinity, kNoHeight, {}}) {}

  void meet(const FaceOnLine& f) {
    Column& column = m_columns[f.pixel];
    const double z = -m_projection.depth(f.depth);
    if (f.body == 0)
      column.low = std::min(column.low, z), column.high = std::max(column.high, z);
    else if (column.high > kNoHeight)
      meet(f, z, column);
  }

  // A column that misses the object says nothing about it.
  std::vector<Column> take() {
    std::vector<Column> out;
    for (size_t i = 0; i < m_columns.size(); ++i) {
      if (m_columns[i].high == kNoHeight) continue;
      m_columns[i].at = at(static_cast<int>(i));
      m_columns[i].others.resize(m_bodies.size() - 1);
      out.push_back(std::move(m_columns[i]));
    }
    return out;
  }

 private:
  Vec2 at(int pixel) const {
    const Projection& p = m_projection;
    const int column = pixel % p.width, row = pixel / p.width;
    const Vec3 point = p.right * (p.corner.x() + (column + 0.5) * p.pixel) +
                       p.up * (p.corner.y() + (row + 0.5) * p.pixel);
    return point.head<2>();
  }

  // Meshes that are no solids have no outside: all their faces carry.
  bool looks_up(const FaceOnLine& f) const {
    if (!m_is_solid[f.body]) return true;
    // The face's normal in the world tells, as poses may turn the mesh over.
    const Body& body = m_bodies[f.body];
    const Triangle t = body.shape->mesh.triangle(static_cast<Index>(f.face));
    const Affine& world = body.world_from_object;
    const Vec3 a = world.apply(t[0]), b = world.apply(t[1]), c = world.apply(t[2]);
    return (b - a).cross(c - a).z() > 0;
  }

  void meet(const FaceOnLine& f, double z, Column& column) const {
    column.others.resize(m_bodies.size() - 1);
    MetObject& met = column.others[f.body - 1];
    met.low = std::min(met.low, z), met.high = std::max(met.high, z);
    // A support is below the column's middle and no higher than its lowest point, within the
    // tolerance.
    const bool under =
        z <= column.low + m_tolerance && z < 0.5 * (column.low + column.high) + m_tolerance;
    if (under && z > met.highest_under && looks_up(f)) met.highest_under = z;
  }

  const std::vector<Body>& m_bodies;
  const std::vector<bool>& m_is_solid;
  const Projection& m_projection;
  double m_tolerance;
  std::vector<Column> m_columns;  // of all pixels
};

}  // namespace

Columns columns_of(const Scene& scene, const PosedObjects& all, size_t object, int num,
                   double tolerance) {
  std::vector<Body> every;
  for (const Placement& p : all) every.push_back(body_of(scene.at(p.id), p.pose));
  Columns out;
  std::vector<Body> bodies{every[object]};
  std::vector<bool> is_solid{true};
  for (const size_t i : near_ones(every, object, tolerance)) {
    bodies.push_back(every[i]);
    is_solid.push_back(scene.at(all[i].id).shape->mass.rule == MassRule::Volume);
    out.others.push_back(all[i].id);
  }
  // The window is the object's own box, seen from above.
  ProjectionOptions options;
  options.resolution = num;
  options.region =
      ImageRegion{bodies[0].world_box.lower.head<2>(), bodies[0].world_box.upper.head<2>()};
  const Projection projection = projection_of(bodies, options);
  out.width = projection.pixel;
  ColumnReader reader(bodies, is_solid, projection, tolerance);
  for_each_face_on_lines(bodies, projection, [&](const FaceOnLine& f) { reader.meet(f); });
  out.columns = reader.take();
  return out;
}

}  // namespace trivet
