#include "ops/arrange/place_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivet {
namespace {

constexpr double kPixelsAcross = 24;      // of the object
constexpr double kMostPixelsAcross = 96;  // of an object in a small window
constexpr double kSlipsThrough = 0.7;  // of its thinner side: a pixel in which it might be unseen
constexpr double kLeastPixelsAcross = 4;  // of a thin one in a large window
constexpr double kCellsAcross = 80;       // of the window
constexpr double kMostCellsAcross = 512;  // of one that is very large for the object
constexpr double kFewPlacesAcross = 10;   // of a window that is small for the object
constexpr double kAside = 0.75;           // pixels that a place may be outside the region
constexpr double kGrown = 1.002;
constexpr double kMostGrown = 256;  // pixels; of larger distances boxes decide, and maps stay small
constexpr int kSingleShare = 4;     // falls are found one by one for a part of the places: 1 in 4

// Distance of two boxes, seen from above.
double seen_distance(const Aabb& a, const Aabb& b) {
  const Vec3 apart = (a.lower - b.upper).cwiseMax(b.lower - a.upper).cwiseMax(Vec3::Zero());
  return apart.head<2>().norm();
}

double largest_stop(double clearance) { return Clearance{clearance}.largest_stop(); }

}  // namespace

LazyFalls::LazyFalls(const HeightMap& object, HeightMap top, int columns, int rows,
                     const DropBracketFunction& brackets)
    : m_object(object),
      m_probe(object),
      m_top(std::move(top)),
      m_columns(columns),
      m_rows(rows),
      m_brackets(brackets) {}

DropBracket LazyFalls::at(int column, int row) {
  // Single falls are cheap at first; when many are asked for, all are found at once.
  if (m_all.empty()) {
    if (kSingleShare * ++m_num_single <= m_columns * m_rows) return m_probe.at(m_top, column, row);
    m_all = m_brackets(m_object, m_top, m_columns, m_rows);
  }
  return m_all[size_t(row) * m_columns + column];
}

PlaceField::PlaceField(const Scene& scene, ObjectId object, const Rotation& rotation,
                       const Landing& landing, const ConvexRegion& region, double clearance,
                       DropBracketFunction brackets)
    : m_scene(scene),
      m_landing(landing),
      m_clearance(clearance),
      m_brackets(std::move(brackets)),
      m_start_z(landing.start_z),
      m_body(body_of(scene.at(object), {rotation, Vec3::Zero()})),
      m_centre(m_body.world_from_object.apply(scene.at(object).shape->mass.centre).head<2>()) {
  set_grid(region);
  set_window();
}

double PlaceField::largest_window(const Aabb& box) {
  return kMostCellsAcross / kLeastPixelsAcross * 2 * box.half_extent().head<2>().minCoeff();
}

void PlaceField::set_grid(const ConvexRegion& region) {
  const Vec2 size = region.upper() - region.lower();
  const double width = 2 * m_body.world_box.half_extent().head<2>().maxCoeff();
  // Pixels that the object would slip through say nothing about it.
  const double thin = 2 * m_body.world_box.half_extent().head<2>().minCoeff();
  // The window may be so large that pixels would hide the object: then they follow its thinner
  // side.
  double least = size.maxCoeff() / kCellsAcross;
  if (least > kSlipsThrough * thin)
    least = std::max(thin / kLeastPixelsAcross, size.maxCoeff() / kMostCellsAcross);
  m_grid.pixel = std::max({std::min(width / kPixelsAcross, size.maxCoeff() / kFewPlacesAcross),
                           least, width / kMostPixelsAcross, 16 * m_clearance});
  // The grid covers the region's box, with its middle in the middle.
  m_grid.columns = static_cast<int>(std::ceil(size.x() / m_grid.pixel)) + 1;
  m_grid.rows = static_cast<int>(std::ceil(size.y() / m_grid.pixel)) + 1;
  const Vec2 span = m_grid.pixel * Vec2(m_grid.columns - 1, m_grid.rows - 1);
  m_grid.first = 0.5 * (region.lower() + region.upper()) - 0.5 * span;
  // Places just outside are moved onto the region's border; others are left out.
  for (int i = 0; i < m_grid.columns * m_grid.rows; ++i) {
    const Vec2 at = m_grid.first + m_grid.pixel * Vec2(i % m_grid.columns, i / m_grid.columns);
    const Vec2 inside = region.nearest(at);
    if ((inside - at).norm() > kAside * m_grid.pixel) continue;
    m_index.push_back(i);
    m_at.push_back(inside);
  }
}

void PlaceField::leave(const std::vector<size_t>& places) {
  for (size_t k = 0; k < places.size(); ++k) {
    m_index[k] = m_index[places[k]];
    m_at[k] = m_at[places[k]];
  }
  m_index.resize(places.size());
  m_at.resize(places.size());
  set_window();
}

void PlaceField::set_window() {
  // The window is the part of the grid that still has places; maps need be no larger.
  int last_column = 0, last_row = 0;
  m_window.column = m_grid.columns, m_window.row = m_grid.rows;
  for (const int index : m_index) {
    const int row = index / m_grid.columns, column = index - row * m_grid.columns;
    m_window.column = std::min(m_window.column, column);
    m_window.row = std::min(m_window.row, row);
    last_column = std::max(last_column, column);
    last_row = std::max(last_row, row);
  }
  m_window.columns = last_column + 1 - m_window.column;
  m_window.rows = last_row + 1 - m_window.row;
  // The reach is the space that the object takes over all of them, from the start down.
  m_reach = m_body.world_box;
  const int first[] = {m_window.column, m_window.row}, last[] = {last_column, last_row};
  for (int k = 0; k < 2; ++k) {
    m_reach.lower[k] += m_grid.first[k] + m_grid.pixel * first[k];
    m_reach.upper[k] += m_grid.first[k] + m_grid.pixel * last[k];
  }
  m_reach.lower.z() = -kInfinity;
  m_reach.upper.z() = m_start_z + 2 * m_body.world_box.half_extent().z();
}

// The grid of the scene's top under all places of an object's map.
MapGrid PlaceField::scene_grid(const MapGrid& object) const {
  MapGrid out = object;
  out.corner += m_grid.first + m_grid.pixel * Vec2(m_window.column, m_window.row);
  out.width = m_window.columns + object.width - 1;
  out.height = m_window.rows + object.height - 1;
  out.level = m_start_z;
  return out;
}

PlaceField::Underside PlaceField::underside_of(std::span<const Body> moving, double growth) const {
  Aabb box = moving.front().world_box;
  for (const Body& body : moving) box.extend(body.world_box);
  box.lower.head<2>() -= Vec2::Constant(growth);
  box.upper.head<2>() += Vec2::Constant(growth);
  const MapGrid grid = MapGrid::about(box, m_grid.pixel, m_body.world_box.lower.z());
  return {growth, grid, draw_underside(moving, grid, growth)};
}

// Underside of the object itself, each growth drawn once.
const PlaceField::Underside& PlaceField::underside(double growth) const {
  for (const Underside& known : m_undersides)
    if (known.growth == growth) return known;
  m_undersides.push_back(underside_of({&m_body, 1}, growth));
  return m_undersides.back();
}

double PlaceField::growth(double keep) const { return kGrown * largest_stop(m_clearance) + keep; }

LazyFalls& PlaceField::supported() const {
  if (m_supported) return *m_supported;
  const Underside& moving = underside(growth(0));
  std::vector<Body> bodies;
  bodies.reserve(m_landing.supports.size());
  // Only supports are drawn: the fall onto them is known apart from all else.
  bool floor = false;
  for (const Support& support : m_landing.supports) {
    if (support.is_floor())
      floor = true;
    else
      bodies.push_back(body_of(m_scene.at(support.object())));
  }
  const double ceiling = m_reach.upper.z() + growth(0);
  return m_supported.emplace(moving.map, draw_top(bodies, scene_grid(moving.grid), floor, ceiling),
                             m_window.columns, m_window.rows, m_brackets);
}

DropBracket PlaceField::support_at(size_t place) const {
  if (m_known.place != place) m_known = {place, fall_at(supported(), place)};
  return m_known.fall;
}

double PlaceField::met_at(size_t place) const {
  return m_start_z - m_body.world_box.lower.z() - support_at(place).upper;
}

bool PlaceField::is_over_rectangle(size_t place) const {
  // The centre of mass has to be over the landing's rectangle.
  const Vec2 centre = m_at[place] + m_centre;
  return (centre.array() >= m_landing.lower.array()).all() &&
         (centre.array() <= m_landing.upper.array()).all();
}

bool PlaceField::is_over_support(size_t place) const {
  if (!is_over_rectangle(place)) return false;
  // The scene must have something under the centre of mass itself.
  const HeightMap& top = supported().top();
  const Vec2 under = (m_centre - underside(growth(0)).grid.corner) / m_grid.pixel;
  const size_t pixel = top.index(column_of(place) - m_window.column + static_cast<int>(under.x()),
                                 row_of(place) - m_window.row + static_cast<int>(under.y()));
  if (!(top.bound[pixel] > -kInfinity)) return false;
  // It has to meet the support for certain, and not below the lowest height allowed.
  const double deepest = m_landing.lowest ? m_start_z - *m_landing.lowest : kInfinity;
  const DropBracket fall = support_at(place);
  return fall.lower >= 0 && fall.upper < kInfinity && fall.upper <= deepest;
}

bool PlaceField::Obstruction::is_clear(size_t place) {
  // The floor is met at the same height at all places.
  if (m_floor) return m_field.support_at(place).upper < *m_floor;
  if (!m_boxes.empty()) {
    Aabb box = m_field.m_body.world_box;
    const Vec3 at(m_field.at(place).x(), m_field.at(place).y(), 0);
    box.lower += at, box.upper += at;
    return std::none_of(m_boxes.begin(), m_boxes.end(), [&](const Aabb& other) {
      return seen_distance(box, other) < kGrown * m_keep;
    });
  }
  // The place is clear if the support is certainly met before anything else.
  return !m_falls || m_field.support_at(place).upper < m_field.fall_at(*m_falls, place).lower;
}

std::unique_ptr<PlaceField::Obstruction> PlaceField::obstruction(
    const Underside& moving, double highest, std::span<const Body> others) const {
  std::unique_ptr<Obstruction> out(new Obstruction(*this));
  out->m_falls.emplace(moving.map,
                       draw_top(others, scene_grid(moving.grid), false, highest + moving.growth),
                       m_window.columns, m_window.rows, m_brackets);
  return out;
}

std::unique_ptr<PlaceField::Obstruction> PlaceField::obstruction(std::span<const ObjectId> others,
                                                                 double keep) const {
  std::vector<Body> bodies;
  bodies.reserve(others.size());
  const double margin = 2 * m_grid.pixel + keep + largest_stop(m_clearance);
  // Objects that are far from all places are left out.
  for (const ObjectId id : others)
    if (overlaps(m_scene.world_box(id), m_reach, margin)) bodies.push_back(body_of(m_scene.at(id)));
  // Short distances grow the object's underside; long ones are judged by boxes.
  if (!bodies.empty() && keep <= kMostGrown * m_grid.pixel)
    return obstruction(underside(growth(keep)), m_reach.upper.z(), bodies);
  std::unique_ptr<Obstruction> out(new Obstruction(*this));
  out->m_keep = keep;
  out->m_boxes.reserve(bodies.size());
  for (const Body& body : bodies) out->m_boxes.push_back(body.world_box);
  return out;
}

std::unique_ptr<PlaceField::Obstruction> PlaceField::obstruction(
    std::span<const Body> others) const {
  if (others.empty()) return std::unique_ptr<Obstruction>(new Obstruction(*this));
  return obstruction(underside(growth(0)), m_reach.upper.z(), others);
}

std::unique_ptr<PlaceField::Obstruction> PlaceField::obstruction(
    std::span<const Body> moving, std::span<const Body> others) const {
  if (moving.empty() || others.empty()) return std::unique_ptr<Obstruction>(new Obstruction(*this));
  // A zone may rise above the object that has it.
  double highest = m_reach.upper.z();
  for (const Body& body : moving)
    highest = std::max(highest, m_start_z + body.world_box.upper.z() - m_body.world_box.lower.z());
  m_undersides_with.push_back(underside_of(moving, growth(0)));
  return obstruction(m_undersides_with.back(), highest, others);
}

// The floor is as far below at every place: what drop_brackets() gives for a map of it alone.
std::unique_ptr<PlaceField::Obstruction> PlaceField::obstruction_of_floor() const {
  const Underside& moving = underside(growth(0));
  MapGrid pixel = moving.grid;
  pixel.width = pixel.height = 1;
  pixel.level = m_start_z;
  const float floor = draw_top({}, pixel, true).bound.front();
  std::unique_ptr<Obstruction> out(new Obstruction(*this));
  out->m_floor = *std::min_element(moving.map.bound.begin(), moving.map.bound.end()) - floor;
  return out;
}

std::vector<char> PlaceField::clear_of(std::span<const ObjectId> others, double keep) const {
  const auto obstruction = this->obstruction(others, keep);
  std::vector<char> out;
  out.reserve(size());
  for (size_t place = 0; place < size(); ++place) out.push_back(obstruction->is_clear(place));
  return out;
}

}  // namespace trivet
