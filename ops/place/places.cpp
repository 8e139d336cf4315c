#include "ops/place/places.h"

#include <algorithm>
#include <cmath>

#include "core/base/tunables.h"
#include "core/contact/pair_contact.h"
#include "ops/move/moving_group.h"
#include "raster/height_map.h"

namespace trivet {
namespace {

// Reproducible on every machine, unlike std::shuffle [Steele 2014, splitmix64].
class Shuffler {
 public:
  explicit Shuffler(std::uint64_t seed) : m_state(seed) {}
  template <class T>
  void shuffle(std::vector<T>& values) {
    for (size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[next() % i]);
  }

 private:
  std::uint64_t next() {
    std::uint64_t z = (m_state += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  std::uint64_t m_state;
};

class PlaceSearch {
 public:
  PlaceSearch(const Scene& scene, ObjectId id, const PlaceRequest& request, double clearance)
      : m_scene(scene),
        m_request(request),
        m_clearance(clearance),
        m_object(scene.at(id)),
        m_body(*m_object.shape,
               world_from_object({request.rotation, Vec3::Zero()}, m_object.up, m_object.scale)),
        m_centre(m_body.world_from_object.apply(m_object.shape->mass.centre)) {
    const std::vector<ObjectId> carried = carried_with(scene, id);
    for (const ObjectId other : scene.ids()) {
      const Object& o = scene.at(other);
      if (!o.placed || std::find(carried.begin(), carried.end(), other) != carried.end()) continue;
      auto& bodies = request.on == other ? m_support : m_others;
      bodies.emplace_back(*o.shape, o.world_from_object());
    }
    set_grid();
  }

  Places run(const DropBracketFunction& brackets) {
    const HeightMap underside = draw_underside({&m_body, 1}, m_grid, 1.002 * grown());
    const HeightMap wide = widened_underside(underside, m_request.keep / m_grid.pixel);
    const HeightMap support = top_of(m_support, underside, !m_request.on);
    const auto on = brackets(underside, support, m_columns, m_rows);
    const HeightMap rest = top_of(m_others, wide, m_scene.floor && m_request.on);
    const auto others = brackets(wide, rest, m_columns, m_rows);
    sort_out(support, on, others);
    return std::move(m_out);
  }

 private:
  double grown() const { return Clearance{m_clearance}.largest_stop(); }

  // What the centre of mass must be over.
  Aabb target() const {
    if (m_request.on) return m_support.front().world_box;
    Aabb box = m_body.world_box;
    const Vec3 size = 2 * box.half_extent();
    const Aabb all = m_scene.box();
    if (!all.empty()) box = all;
    if (m_request.near) box.extend(Vec3(m_request.near->x(), m_request.near->y(), 0));
    box.lower.head<2>() -= size.head<2>();
    box.upper.head<2>() += size.head<2>();
    return {Vec3(box.lower.x(), box.lower.y(), 0), Vec3(box.upper.x(), box.upper.y(), 0)};
  }

  void set_grid() {
    const Aabb to = target();
    const Vec2 object_size = 2 * m_body.world_box.half_extent().head<2>();
    const Vec2 size = 2 * to.half_extent().head<2>();
    const double pixel =
        std::max({object_size.maxCoeff() / kPlacePixelsAcross, size.maxCoeff() / kPlacesAcross,
                  m_request.keep / kPlacePixelsAcross, 16 * m_clearance});
    m_start_z = m_request.from.value_or(to.upper.z() + 4 * m_clearance);
    m_grid = MapGrid::about(m_body.world_box, pixel, m_body.world_box.lower.z());
    m_columns = static_cast<int>(std::ceil(size.x() / pixel)) + 1;
    m_rows = static_cast<int>(std::ceil(size.y() / pixel)) + 1;
    const Vec2 span = pixel * Vec2(m_columns - 1, m_rows - 1);
    m_first = to.centre().head<2>() - 0.5 * span - m_centre.head<2>();
    m_out.spacing = pixel;
  }

  // Under all places of a map of the object's underside.
  HeightMap top_of(const std::vector<Body>& bodies, const HeightMap& underside, bool floor) const {
    MapGrid grid = m_grid;
    const double wider = 0.5 * (underside.width - m_grid.width);
    grid.corner += m_first - Vec2::Constant(wider * grid.pixel);
    grid.width = m_columns + underside.width - 1;
    grid.height = m_rows + underside.height - 1;
    grid.level = m_start_z;
    const double top = m_start_z + 2 * m_body.world_box.half_extent().z() + grown();
    return draw_top(bodies, grid, floor, top);
  }

  Pose start(int column, int row) const {
    const Vec2 at = m_first + m_grid.pixel * Vec2(column, row);
    return {m_request.rotation,
            Vec3(at.x(), at.y(), m_start_z - m_body.world_box.lower.z() + m_clearance)};
  }

  void sort_out(const HeightMap& support, const std::vector<DropBracket>& on,
                const std::vector<DropBracket>& others) {
    const Vec2 centre = (m_centre.head<2>() - m_grid.corner) / m_grid.pixel;
    const int centre_x = static_cast<int>(centre.x()), centre_y = static_cast<int>(centre.y());
    std::vector<int> fitting;
    m_out.num_judged = static_cast<std::int64_t>(on.size());
    for (int i = 0; i < static_cast<int>(on.size()); ++i) {
      const size_t under = support.index(i % m_columns + centre_x, i / m_columns + centre_y);
      if (!(support.bound[under] > -kInfinity) || !(on[i].upper < kInfinity))
        ++m_out.num_beside;
      else if (!(on[i].upper < others[i].lower) || on[i].lower < 0)
        ++m_out.num_blocked;
      else
        fitting.push_back(i);
    }
    rank(fitting);
    for (const int i : fitting) m_out.starts.push_back(start(i % m_columns, i / m_columns));
  }

  void rank(std::vector<int>& places) const {
    if (!m_request.near) return Shuffler(m_request.seed).shuffle(places);
    std::vector<std::pair<double, int>> order;
    for (const int i : places) {
      const Vec3 at = start(i % m_columns, i / m_columns).translation + m_centre;
      order.emplace_back((at.head<2>() - *m_request.near).squaredNorm(), i);
    }
    std::sort(order.begin(), order.end());
    for (size_t k = 0; k < places.size(); ++k) places[k] = order[k].second;
  }

  const Scene& m_scene;
  const PlaceRequest& m_request;
  double m_clearance;
  const Object& m_object;
  Body m_body;  // with its origin at the world's
  Vec3 m_centre;
  std::vector<Body> m_support, m_others;
  MapGrid m_grid;  // of the body
  double m_start_z = 0;
  int m_columns = 0, m_rows = 0;
  Vec2 m_first;  // the object's position at place (0, 0)
  Places m_out;
};

}  // namespace

Places find_places(const Scene& scene, ObjectId object, const PlaceRequest& request,
                   double clearance, const DropBracketFunction& brackets) {
  return PlaceSearch(scene, object, request, clearance).run(brackets);
}

}  // namespace trivet
