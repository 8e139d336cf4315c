#include "ops/mend/columns.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

constexpr double kReachBelow = 5;  // tolerances below an object, in which others count

bool is_near(const Body& object, const Body& other, double tolerance) {
  Aabb box = object.world_box;
  // The reach below the object finds supports from which noise has lifted it.
  box.lower.z() -= kReachBelow * tolerance + 0.02;
  box.upper.z() += tolerance;
  return overlaps(box, other.world_box);
}

/// The object, then others that a column of it may meet near it.
std::vector<Body> near_bodies_of(const Scene& scene, const PosedObjects& all, size_t object,
                                 double tolerance, std::vector<ObjectId>& others) {
  const auto body = [&](size_t i) { return body_of(scene.at(all[i].id), all[i].pose); };
  std::vector<Body> out{body(object)};
  for (size_t i = 0; i < all.size(); ++i) {
    if (i == object) continue;
    Body other = body(i);
    if (!is_near(out[0], other, tolerance)) continue;
    out.push_back(std::move(other));
    others.push_back(all[i].id);
  }
  return out;
}

// The window is the object's own box, seen from above.
ProjectionOptions window_of(const Body& object, int num) {
  ProjectionOptions out;
  out.resolution = num;
  out.region = ImageRegion{object.world_box.lower.head<2>(), object.world_box.upper.head<2>()};
  return out;
}

class ColumnReader {
 public:
  /// @param place_of  of each body, among the others of a column; kNone: it is not near.
  ColumnReader(const std::vector<Body>& bodies, const std::vector<bool>& is_solid,
               const std::vector<size_t>& place_of, const CompleteZLists& lists, double tolerance)
      : m_bodies(bodies),
        m_is_solid(is_solid),
        m_place_of(place_of),
        m_num_others(static_cast<size_t>(std::count_if(
            place_of.begin(), place_of.end(), [](size_t place) { return place != kNone; }))),
        m_lists(lists),
        m_tolerance(tolerance) {}

  static constexpr size_t kNone = static_cast<size_t>(-1);

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
        column.others.resize(m_num_others);
        for (const ZListItem& item : list)
          if (m_place_of[item.body] != kNone && std::isfinite(item.centre)) meet(item, column);
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
    MetObject& met = column.others[m_place_of[item.body]];
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
  const std::vector<size_t>& m_place_of;
  const size_t m_num_others;
  const CompleteZLists& m_lists;
  double m_tolerance;
};

}  // namespace

ColumnLists::ColumnLists(const Scene& scene, const PosedObjects& all, size_t object, int num,
                         double most_tolerance)
    : m_most_tolerance(most_tolerance),
      m_bodies(near_bodies_of(scene, all, object, most_tolerance, m_others)),
      m_lists(m_bodies, window_of(m_bodies[0], num)) {
  m_is_solid.push_back(true);
  for (const ObjectId id : m_others)
    m_is_solid.push_back(scene.at(id).shape->mass.rule == MassRule::Volume);
}

Columns ColumnLists::read(double tolerance) const {
  Columns out;
  out.width = m_lists.projection().pixel;
  std::vector<size_t> place_of(m_bodies.size(), ColumnReader::kNone);
  for (size_t i = 1; i < m_bodies.size(); ++i) {
    if (!is_near(m_bodies[0], m_bodies[i], tolerance)) continue;
    place_of[i] = out.others.size();
    out.others.push_back(m_others[i - 1]);
  }
  out.columns = ColumnReader(m_bodies, m_is_solid, place_of, m_lists, tolerance).read();
  return out;
}

}  // namespace trivet
