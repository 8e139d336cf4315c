#include "ops/arrange/place_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivet {
namespace {

constexpr double kPixelsAcross = 24;      // of the object
constexpr double kMostPixelsAcross = 96;  // of an object in a small window
constexpr double kCellsAcross = 80;       // of the window
constexpr double kFewPlacesAcross = 10;   // of a window that is small for the object
constexpr double kAside = 0.75;           // pixels that a place may be outside the region
constexpr double kGrown = 1.002;

double largest_stop(double clearance) { return Clearance{clearance}.largest_stop(); }

}  // namespace

PlaceField::PlaceField(const Scene& scene, ObjectId object, const Rotation& rotation,
                       const Landing& landing, const ConvexRegion& region, double clearance,
                       DropBracketFunction brackets)
    : m_scene(scene),
      m_clearance(clearance),
      m_brackets(std::move(brackets)),
      m_start_z(landing.start_z),
      m_body(body_of(scene.at(object), {rotation, Vec3::Zero()})),
      m_centre(m_body.world_from_object.apply(scene.at(object).shape->mass.centre).head<2>()) {
  set_grid(region);
  find_supported(landing);
}

void PlaceField::set_grid(const ConvexRegion& region) {
  const Vec2 size = region.upper() - region.lower();
  const double width = 2 * m_body.world_box.half_extent().head<2>().maxCoeff();
  m_grid.pixel =
      std::max({std::min(width / kPixelsAcross, size.maxCoeff() / kFewPlacesAcross),
                size.maxCoeff() / kCellsAcross, width / kMostPixelsAcross, 16 * m_clearance});
  m_grid.columns = static_cast<int>(std::ceil(size.x() / m_grid.pixel)) + 1;
  m_grid.rows = static_cast<int>(std::ceil(size.y() / m_grid.pixel)) + 1;
  const Vec2 span = m_grid.pixel * Vec2(m_grid.columns - 1, m_grid.rows - 1);
  m_grid.first = 0.5 * (region.lower() + region.upper()) - 0.5 * span;
  for (int i = 0; i < m_grid.columns * m_grid.rows; ++i) {
    const Vec2 at = m_grid.first + m_grid.pixel * Vec2(i % m_grid.columns, i / m_grid.columns);
    const Vec2 inside = region.nearest(at);
    if ((inside - at).norm() > kAside * m_grid.pixel) continue;
    m_index.push_back(i);
    m_at.push_back(inside);
  }
  m_reach = m_body.world_box;
  for (int k = 0; k < 2; ++k) {
    m_reach.lower[k] += m_grid.first[k];
    m_reach.upper[k] += m_grid.first[k] + span[k];
  }
  m_reach.lower.z() = -kInfinity;
  m_reach.upper.z() = m_start_z + 2 * m_body.world_box.half_extent().z();
}

// The grid of the scene's top under all places of an object's map.
MapGrid PlaceField::scene_grid(const MapGrid& object) const {
  MapGrid out = object;
  out.corner += m_grid.first;
  out.width = m_grid.columns + object.width - 1;
  out.height = m_grid.rows + object.height - 1;
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

// Of the object itself, each growth drawn once.
const PlaceField::Underside& PlaceField::underside(double growth) const {
  for (const Underside& known : m_undersides)
    if (known.growth == growth) return known;
  m_undersides.push_back(underside_of({&m_body, 1}, growth));
  return m_undersides.back();
}

double PlaceField::growth(double keep) const { return kGrown * largest_stop(m_clearance) + keep; }

void PlaceField::find_supported(const Landing& landing) {
  const Underside& moving = underside(growth(0));
  std::vector<Body> bodies;
  bool floor = false;
  for (const Support& support : landing.supports) {
    if (support.is_floor())
      floor = true;
    else
      bodies.push_back(body_of(m_scene.at(support.object())));
  }
  const double ceiling = m_reach.upper.z() + growth(0);
  const HeightMap top = draw_top(bodies, scene_grid(moving.grid), floor, ceiling);
  const auto falls = m_brackets(moving.map, top, m_grid.columns, m_grid.rows);
  m_upper.reserve(falls.size());
  for (const DropBracket& fall : falls) m_upper.push_back(fall.upper);
  const Vec2 under = (m_centre - moving.grid.corner) / m_grid.pixel;
  const double deepest = landing.lowest ? m_start_z - *landing.lowest : kInfinity;
  m_over.reserve(m_index.size());
  for (size_t k = 0; k < m_index.size(); ++k) {
    const int i = m_index[k], column = i % m_grid.columns, row = i / m_grid.columns;
    const size_t pixel =
        top.index(column + static_cast<int>(under.x()), row + static_cast<int>(under.y()));
    const Vec2 centre = m_at[k] + m_centre;
    const bool in_rectangle = (centre.array() >= landing.lower.array()).all() &&
                              (centre.array() <= landing.upper.array()).all();
    m_over.push_back(in_rectangle && top.bound[pixel] > -kInfinity && falls[i].lower >= 0 &&
                     falls[i].upper < kInfinity && falls[i].upper <= deepest);
  }
}

std::vector<char> PlaceField::clear(const Underside& moving, double highest,
                                    std::span<const Body> others) const {
  const HeightMap top = draw_top(others, scene_grid(moving.grid), false, highest + moving.growth);
  const auto falls = m_brackets(moving.map, top, m_grid.columns, m_grid.rows);
  std::vector<char> out;
  out.reserve(m_index.size());
  for (const int i : m_index) out.push_back(m_upper[i] < falls[i].lower);
  return out;
}

std::vector<char> PlaceField::clear_of(std::span<const ObjectId> others, double keep) const {
  std::vector<Body> bodies;
  bodies.reserve(others.size());
  const double margin = 2 * m_grid.pixel + keep + largest_stop(m_clearance);
  for (const ObjectId id : others)
    if (overlaps(m_scene.world_box(id), m_reach, margin)) bodies.push_back(body_of(m_scene.at(id)));
  if (bodies.empty()) return std::vector<char>(m_index.size(), 1);
  return clear(underside(growth(keep)), m_reach.upper.z(), bodies);
}

std::vector<char> PlaceField::clear_of_bodies(std::span<const Body> others) const {
  if (others.empty()) return std::vector<char>(m_index.size(), 1);
  return clear(underside(growth(0)), m_reach.upper.z(), others);
}

std::vector<char> PlaceField::clear_of_bodies(std::span<const Body> moving,
                                              std::span<const Body> others) const {
  if (moving.empty() || others.empty()) return std::vector<char>(m_index.size(), 1);
  double highest = m_reach.upper.z();
  for (const Body& body : moving)
    highest = std::max(highest, m_start_z + body.world_box.upper.z() - m_body.world_box.lower.z());
  return clear(underside_of(moving, growth(0)), highest, others);
}

// The floor is as far below at every place: what drop_brackets() gives for a map of it alone.
std::vector<char> PlaceField::clear_of_floor() const {
  const Underside& moving = underside(growth(0));
  MapGrid pixel = moving.grid;
  pixel.width = pixel.height = 1;
  pixel.level = m_start_z;
  const float floor = draw_top({}, pixel, true).bound.front();
  const float lower = *std::min_element(moving.map.bound.begin(), moving.map.bound.end()) - floor;
  std::vector<char> out;
  out.reserve(m_index.size());
  for (const int i : m_index) out.push_back(m_upper[i] < lower);
  return out;
}

}  // namespace trivet
