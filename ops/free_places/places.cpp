#include "ops/free_places/places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/tunables.h"
#include "core/contact/pair_contact.h"
#include "ops/free_places/place_setting.h"
#include "ops/free_places/shuffler.h"
#include "raster/height_map/height_map.h"

namespace trivet {
namespace {

// Between places beyond everything, of their distance.
constexpr double kBeyondStep = 1.0 / 16;

double pixel_of(const PlaceSetting& setting, const Vec2& window_size) {
  // Pixels follow the object, unless the window is too large or they would be near the clearance.
  return std::max({setting.width() / kPlacePixelsAcross, window_size.maxCoeff() / kPlacesAcross,
                   16 * setting.clearance});
}

// Region that the centre of mass must be over, seen from above; `more` metres beyond all things on
// the floor.
PlaceWindow area_of(const PlaceSetting& setting, const PlaceRequest& request, double more) {
  const PlaceRegion& region = setting.region;
  if (setting.on_floor() && !region.is_all()) return {region.lower(), region.upper()};
  Aabb box = setting.on_floor() ? setting.others.box() : setting.support->world_box;
  if (setting.on_floor()) {
    if (request.near) box.extend(Vec3(request.near->x(), request.near->y(), 0));
    if (box.empty()) box = setting.body.world_box;
    Vec2 about = 2 * setting.body.world_box.half_extent().head<2>() + Vec2::Constant(more);
    // And a little, as the maps leave out what is nearer than pixels to being blocked.
    const double pixel = pixel_of(setting, 2 * box.half_extent().head<2>() + 2 * about);
    about += Vec2::Constant(8 * pixel + 4 / kPlaceKeepPixels * more);
    box.lower.head<2>() -= about;
    box.upper.head<2>() += about;
  }
  return {box.lower.head<2>().cwiseMax(region.lower()),
          box.upper.head<2>().cwiseMin(region.upper())};
}

// Seen from above.
Vec2 inside_largest_face(const Body& body) {
  Vec2 out = Vec2::Zero();
  double largest = -1;
  for (Index f = 0; f < static_cast<Index>(body.shape->mesh.triangles.size()); ++f) {
    const Triangle t = body.triangle(f);
    const Vec3 a = t[1] - t[0], b = t[2] - t[0];
    const double area = std::abs(a.x() * b.y() - a.y() * b.x());
    if (!(area > largest)) continue;
    largest = area;
    out = (t[0] + t[1] + t[2]).head<2>() / 3;
  }
  return out;
}

class PlaceSearch {
 public:
  PlaceSearch(const Scene& scene, ObjectId id, std::span<const ObjectId> carried,
              const PlaceRequest& request, double clearance)
      : m_setting(scene, id, carried, request, clearance), m_request(request) {
    set_grid();
  }

  Places run(const DropBracketFunction& brackets) {
    // The underside, the support's top and the top of all else decide, pixel by pixel.
    HeightMap underside = underside_on_grid();
    const HeightMap support = top_of_support(underside);
    const std::vector<float> falls = falls_onto(support, underside, brackets);
    // Without a distance to keep, the others' top is that of the bodies.
    if (!(m_keep > 0)) {
      take_starts(falls, underside, top_of_others(underside));
      return std::move(m_out);
    }
    const HeightMap about = top_about(support);
    // Two pixels may hold points that are closer or farther than their centres by a diagonal.
    const double reach = m_keep / (m_coarse * m_grid.pixel);
    take_starts(falls, underside, top_within(reach + kDiagonal, about, underside));
    // Places that may keep the distance are told as doubtful if none does for certain.
    if (m_out.starts.empty()) {
      const double sure = std::max(reach - kDiagonal, 0.0);
      m_out.doubtful = ranked(farther_than(falls, underside, top_within(sure, about, underside)));
    }
    return std::move(m_out);
  }

 private:
  using Brackets = std::vector<DropBracket>;
  static constexpr double kDiagonal = 1.5;  // of a pixel, and a little
  static constexpr float kNever = static_cast<float>(kInfinity);

  double grown() const { return Clearance{m_setting.clearance}.largest_stop(); }

  void set_grid() {
    const PlaceWindow area = area_of(m_setting, m_request, m_request.keep);
    const PlaceWindow to = m_request.within.value_or(area);
    const Vec2 size = to.upper - to.lower;
    // The grid has a pixel for each place of the object, with the window's middle in its middle.
    const double pixel = pixel_of(m_setting, size);
    // Beyond that everything is too near to all places.
    m_keep = std::min(m_request.keep, span_of_all(to));
    // Distances to keep are judged in coarser pixels, so that maps stay small.
    m_coarse = static_cast<int>(std::max(1.0, std::ceil(m_keep / (kPlaceKeepPixels * pixel))));
    m_border = static_cast<int>(m_keep / (m_coarse * pixel) + kDiagonal);
    m_grid = MapGrid::about(m_setting.body.world_box, pixel, m_setting.body.world_box.lower.z());
    m_columns = static_cast<int>(std::ceil(size.x() / pixel)) + 1;
    m_rows = static_cast<int>(std::ceil(size.y() / pixel)) + 1;
    const Vec2 span = pixel * Vec2(m_columns - 1, m_rows - 1);
    m_first = 0.5 * (to.lower + to.upper) - 0.5 * span - m_setting.centre.head<2>();
    m_out.spacing = pixel;
    m_out.doubt = m_keep > 0 ? 2 * (kDiagonal + 1) * m_coarse * pixel : 0;
  }

  // An object that is small for the pixels may miss all their centres: the largest of its faces is
  // shifted onto one.
  HeightMap underside_on_grid() {
    HeightMap out = draw_underside({&m_setting.body, 1}, m_grid, 1.002 * grown());
    const auto met = [](float height) { return height < kInfinity; };
    if (std::any_of(out.sample.begin(), out.sample.end(), met)) return out;
    const Vec2 at = (inside_largest_face(m_setting.body) - m_grid.corner) / m_grid.pixel;
    for (int k = 0; k < 2; ++k)
      m_grid.corner[k] += m_grid.pixel * (at[k] - std::floor(at[k]) - 0.5);
    return draw_underside({&m_setting.body, 1}, m_grid, 1.002 * grown());
  }

  double span_of_all(const PlaceWindow& area) const {
    Aabb box{Vec3(area.lower.x(), area.lower.y(), 0), Vec3(area.upper.x(), area.upper.y(), 0)};
    box.extend(m_setting.others.box());
    return 2 * box.half_extent().head<2>().norm() + 2 * m_setting.width();
  }

  double ceiling() const {
    return m_setting.start_z + 2 * m_setting.body.world_box.half_extent().z() + grown();
  }

  // Under all places of a map of the object's underside.
  MapGrid grid_under(int width, int height) const {
    MapGrid grid = m_grid;
    grid.corner += m_first;
    grid.width = m_columns + width - 1;
    grid.height = m_rows + height - 1;
    grid.level = m_setting.start_z;
    return grid;
  }

  // The other bodies that may be drawn on a grid.
  std::vector<Body> others_on(const MapGrid& grid) const {
    const Vec2 size = grid.pixel * Vec2(grid.width, grid.height);
    Aabb box{Vec3(grid.corner.x(), grid.corner.y(), -kInfinity),
             Vec3(grid.corner.x() + size.x(), grid.corner.y() + size.y(), kInfinity)};
    return m_setting.others.near(box, 2 * grid.pixel + grown()).bodies;
  }

  HeightMap top_of_support(const HeightMap& underside) const {
    // The support is drawn apart from the others.
    std::vector<Body> support;
    if (m_setting.support) support.push_back(*m_setting.support);
    return draw_top(support, grid_under(underside.width, underside.height), m_setting.on_floor(),
                    ceiling());
  }

  HeightMap top_of_others(const HeightMap& underside) const {
    return top_of(others_on(grid_under(underside.width, underside.height)), underside);
  }

  HeightMap top_of(std::span<const Body> bodies, const HeightMap& underside) const {
    return draw_top(bodies, grid_under(underside.width, underside.height),
                    m_setting.others.floor() && !m_setting.on_floor(), ceiling(), MapParts::Bounds);
  }

  // Coarse pixels bound what is over the fine ones in them, which need not be drawn.
  HeightMap top_within(double reach, const HeightMap& about, const HeightMap& underside) const {
    HeightMap out = top_of({}, underside);
    take_higher(widened_top(about, reach, m_border), out);
    return out;
  }

  // Everything else in coarse pixels, under all places and as far about them as is to be kept.
  HeightMap top_about(const HeightMap& fine) const {
    MapGrid grid = grid_under(m_grid.width, m_grid.height);
    grid.pixel *= m_coarse;
    grid.corner -= Vec2::Constant(m_border * grid.pixel);
    grid.width = (fine.width + m_coarse - 1) / m_coarse + 2 * m_border;
    grid.height = (fine.height + m_coarse - 1) / m_coarse + 2 * m_border;
    return draw_top(others_on(grid), grid, false, ceiling(), MapParts::Bounds);
  }

  void take_higher(const HeightMap& coarse, HeightMap& fine) const {
    for (int y = 0; y < fine.height; ++y) {
      const float* highest = &coarse.bound[coarse.index(0, y / m_coarse)];
      float* const bound = &fine.bound[fine.index(0, y)];
      for (int first = 0; first < fine.width; first += m_coarse, ++highest)
        for (int x = first; x < std::min(first + m_coarse, fine.width); ++x)
          bound[x] = std::max(bound[x], *highest);
    }
  }

  Vec2 centre_at(int place) const {
    return m_first + m_grid.pixel * Vec2(place % m_columns, place / m_columns) +
           m_setting.centre.head<2>();
  }

  bool is_over(const HeightMap& support, const Brackets& on, int place) const {
    const Vec2 centre = (m_setting.centre.head<2>() - m_grid.corner) / m_grid.pixel;
    const int centre_x = static_cast<int>(centre.x()), centre_y = static_cast<int>(centre.y());
    const size_t under = support.index(place % m_columns + centre_x, place / m_columns + centre_y);
    return support.bound[under] > -kInfinity && on[place].upper < kInfinity;
  }

  // The fall onto the support at each place; infinite where the object cannot be put whatever else
  // there is.
  std::vector<float> falls_onto(const HeightMap& support, const HeightMap& underside,
                                const DropBracketFunction& brackets) {
    // Only the sign of the lower bounds matters, which costs less alone.
    HeightMap samples = underside;
    std::fill(samples.bound.begin(), samples.bound.end(), kNever);
    const Brackets on = brackets(samples, support, m_columns, m_rows);
    m_out.num_judged = static_cast<std::int64_t>(on.size());
    constexpr float kBelowZero = -std::numeric_limits<float>::denorm_min();
    std::vector<float> out(on.size(), kNever);
    // The reasons why places fail are counted, for the refusal.
    for (int i = 0; i < static_cast<int>(on.size()); ++i) {
      if (!m_setting.region.holds(centre_at(i)))
        ++m_out.num_outside;
      else if (!is_over(support, on, i))
        ++m_out.num_beside;
      else
        out[i] = kBelowZero;
    }
    const std::vector<char> is_above = falls_farther(underside, support, m_columns, m_rows, out);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = is_above[i] ? on[i].upper : kNever;
    return out;
  }

  // Places at which the object reaches the support before it may touch the others.
  std::vector<int> farther_than(const std::vector<float>& falls, const HeightMap& underside,
                                const HeightMap& others) const {
    const std::vector<char> is_farther = falls_farther(underside, others, m_columns, m_rows, falls);
    std::vector<int> out;
    for (int i = 0; i < static_cast<int>(falls.size()); ++i)
      if (is_farther[i]) out.push_back(i);
    return out;
  }

  void take_starts(const std::vector<float>& falls, const HeightMap& underside,
                   const HeightMap& others) {
    m_out.starts = ranked(farther_than(falls, underside, others));
    m_out.num_blocked = m_out.num_judged - m_out.num_outside - m_out.num_beside -
                        static_cast<std::int64_t>(m_out.starts.size());
  }

  std::vector<Pose> ranked(std::vector<int> places) const {
    if (m_request.near) {
      // Places come by distance from the point, or shuffled by the seed.
      std::vector<std::pair<double, int>> order;
      order.reserve(places.size());
      for (const int i : places)
        order.emplace_back((centre_at(i) - *m_request.near).squaredNorm(), i);
      std::sort(order.begin(), order.end());
      for (size_t k = 0; k < places.size(); ++k) places[k] = order[k].second;
    } else {
      Shuffler(m_request.seed).shuffle(places);
    }
    std::vector<Pose> out;
    out.reserve(places.size());
    for (const int i : places) out.push_back(m_setting.start(m_request.rotation, centre_at(i)));
    return out;
  }

  PlaceSetting m_setting;
  const PlaceRequest& m_request;
  double m_keep = 0;
  MapGrid m_grid;  // of the body
  int m_columns = 0, m_rows = 0;
  int m_coarse = 1;  // pixels in a coarse one
  int m_border = 0;  // coarse pixels about the maps: as far as is to be kept
  Vec2 m_first;      // the object's position at place (0, 0)
  Places m_out;
};

}  // namespace

std::vector<PlaceWindow> place_windows(const Scene& scene, ObjectId object,
                                       std::span<const ObjectId> carried,
                                       const PlaceRequest& request, double clearance) {
  const PlaceSetting setting(scene, object, carried, request, clearance);
  const PlaceWindow all = area_of(setting, request, request.keep);
  std::vector<PlaceWindow> out;
  if ((all.lower.array() > all.upper.array()).any()) return out;
  // Near a point the windows grow: most searches end in the first.
  if (request.near) {
    const Vec2 nearest = request.near->cwiseMax(all.lower).cwiseMin(all.upper);
    const double fine = std::max(setting.width() / kPlacePixelsAcross, 16 * clearance);
    const double all_in = std::max((all.upper - *request.near).cwiseAbs().maxCoeff(),
                                   (all.lower - *request.near).cwiseAbs().maxCoeff());
    for (double half = (nearest - *request.near).norm() + kPlacesAcross / 4 * fine; half < all_in;
         half *= 2) {
      const Vec2 extent = Vec2::Constant(half);
      out.push_back({(*request.near - extent).cwiseMax(all.lower),
                     (*request.near + extent).cwiseMin(all.upper), half});
    }
  } else if (setting.on_floor() && request.keep > 0 && setting.region.is_all()) {
    out.push_back(area_of(setting, request, 0));
  }
  out.push_back(all);
  return out;
}

Places places_beyond(const Scene& scene, ObjectId object, std::span<const ObjectId> carried,
                     const PlaceRequest& request, double clearance) {
  const PlaceSetting setting(scene, object, carried, request, clearance);
  Places out;
  // Only the unbounded floor has room beyond everything.
  const Aabb box = setting.others.box();
  if (!setting.on_floor() || box.empty() || !setting.region.is_all()) return out;
  // Half a width more than is asked for: far out, clearances are larger.
  const double beyond = box.half_extent().head<2>().norm() + 2 * setting.width() + request.keep;
  out.spacing = beyond * kBeyondStep;
  const int half = static_cast<int>(std::ceil(1 / kBeyondStep));
  // On the sides of a square about everything.
  for (int k = -half; k < half; ++k)
    for (const Vec2& at : {Vec2(k, -half), Vec2(half, k), Vec2(-k, half), Vec2(-half, -k)})
      out.starts.push_back(setting.start(request.rotation,
                                         Vec2(box.centre().head<2>() + beyond * kBeyondStep * at)));
  if (request.near) {
    const auto distance = [&](const Pose& start) {
      return (start.translation.head<2>() + setting.centre.head<2>() - *request.near).squaredNorm();
    };
    std::stable_sort(out.starts.begin(), out.starts.end(),
                     [&](const Pose& a, const Pose& b) { return distance(a) < distance(b); });
  } else {
    Shuffler(request.seed).shuffle(out.starts);
  }
  out.num_judged = static_cast<std::int64_t>(out.starts.size());
  return out;
}

Places find_places(const Scene& scene, ObjectId object, std::span<const ObjectId> carried,
                   const PlaceRequest& request, double clearance,
                   const DropBracketFunction& brackets) {
  return PlaceSearch(scene, object, carried, request, clearance).run(brackets);
}

}  // namespace trivet
