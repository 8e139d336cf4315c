#include "ops/mend/columns.h"

#include <Eigen/Geometry>
#include <cmath>

#include "raster/zlist/complete_zlists.h"

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

class ColumnReader {
 public:
  ColumnReader(const std::vector<Body>& bodies, const std::vector<bool>& is_solid,
               const CompleteZLists& lists, double tolerance)
      : m_bodies(bodies), m_is_solid(is_solid), m_lists(lists), m_tolerance(tolerance) {}

  /// The body of index 0 is the object.
  std::vector<Column> read() const {
    std::vector<Column> out;
    const Projection& p = m_lists.projection();
    // Every line of sight down through the object is a column.
    for (int row = 0; row < p.height; ++row)
      for (int x = 0; x < p.width; ++x) {
        Column column{at(p, x, row), kInfinity, kNoHeight, {}};
        const auto list = m_lists.list(x, row);
        for (const ZListItem& item : list)
          if (item.body == 0 && std::isfinite(item.centre)) {
            const double z = height(item);
            column.low = std::min(column.low, z), column.high = std::max(column.high, z);
          }
        // A column that misses the object says nothing about it.
        if (column.high == kNoHeight) continue;
        column.others.resize(m_bodies.size() - 1);
        for (const ZListItem& item : list)
          if (item.body != 0 && std::isfinite(item.centre)) meet(item, column);
        out.push_back(std::move(column));
      }
    return out;
  }

 private:
  static Vec2 at(const Projection& p, int x, int row) {
    const Vec3 point = p.right * (p.corner.x() + (x + 0.5) * p.pixel) +
                       p.up * (p.corner.y() + (row + 0.5) * p.pixel);
    return point.head<2>();
  }

  double height(const ZListItem& item) const { return -m_lists.projection().depth(item.centre); }

  // Meshes that are no solids have no outside: all their faces carry.
  bool looks_up(const ZListItem& item) const {
    if (!m_is_solid[item.body]) return true;
    // The face's normal in the world tells, as poses may turn the mesh over.
    const Body& body = m_bodies[item.body];
    const Triangle t = body.shape->mesh.triangle(static_cast<Index>(item.face));
    const Affine& world = body.world_from_object;
    const Vec3 a = world.apply(t[0]), b = world.apply(t[1]), c = world.apply(t[2]);
    return (b - a).cross(c - a).z() > 0;
  }

  void meet(const ZListItem& item, Column& column) const {
    MetObject& met = column.others[item.body - 1];
    const double z = height(item);
    met.low = std::min(met.low, z), met.high = std::max(met.high, z);
    // A support is below the column's middle and no higher than its lowest point, within the
    // tolerance.
    const bool under =
        z <= column.low + m_tolerance && z < 0.5 * (column.low + column.high) + m_tolerance;
    if (under && z > met.highest_under && looks_up(item)) met.highest_under = z;
  }

  const std::vector<Body>& m_bodies;
  const std::vector<bool>& m_is_solid;
  const CompleteZLists& m_lists;
  double m_tolerance;
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
  const CompleteZLists lists(bodies, options);
  out.width = lists.projection().pixel;
  out.columns = ColumnReader(bodies, is_solid, lists, tolerance).read();
  return out;
}

}  // namespace trivet
