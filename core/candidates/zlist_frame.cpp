#include "core/candidates/zlist_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/outward.h"

// Bounds alone, no answers: libm is allowed, and every bound has room for its rounding.

namespace trivet {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kAngleSlack = 1e-9;    // radians; of angles from atan2
constexpr double kTimeSlack = 1e-12;    // relative
constexpr double kExtentSlack = 1e-14;  // of coordinates, relative to the largest
constexpr double kLargestRadius = 5e4;  // pixels; float32 still tells 0.01 pixels apart

// Extent of a body: columns, rows and depths; metres, and radians of a turn.
struct Extent {
  Vec3 lower = Vec3::Constant(kInfinity), upper = Vec3::Constant(-kInfinity);

  void extend(const Extent& e) {
    lower = lower.cwiseMin(e.lower);
    upper = upper.cwiseMax(e.upper);
  }
};

std::array<Vec3, 8> corners(const Body& body, const Mat3& image_from_world, const Vec3& origin) {
  // The box in the object's frame is tighter than the one in the world, and is brought to the image
  // corner by corner.
  const Aabb box = rounded_outwards(body.shape->box);
  std::array<Vec3, 8> out;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1 ? box.upper.x() : box.lower.x(), i & 2 ? box.upper.y() : box.lower.y(),
                      i & 4 ? box.upper.z() : box.lower.z());
    out[i] = image_from_world * (body.world_from_object.apply(corner) - origin);
  }
  return out;
}

Extent straight_extent(const std::array<Vec3, 8>& box) {
  Extent out;
  for (const Vec3& p : box) out.extend({p, p});
  return out;
}

// Distance of the corners' convex hull from the axis. Its nearest point is a corner or lies on an
// edge, which is the image of an edge of the box.
double smallest_radius(const std::array<Vec3, 8>& box) {
  double out = 0;
  const auto try_direction = [&](Vec2 d) {
    if (d.norm() == 0) return;
    d.normalize();
    double low = kInfinity;
    for (const Vec3& p : box) low = std::min(low, d.dot(p.head<2>()));
    out = std::max(out, low);
  };
  for (const Vec3& p : box) try_direction(p.head<2>());
  // The edges from corner 0 lead to corners 1, 2 and 4, and give all three directions of the box's
  // edges.
  for (const int k : {1, 2, 4}) {
    const Vec2 edge = (box[k] - box[0]).head<2>();
    try_direction({-edge.y(), edge.x()});
    try_direction({edge.y(), -edge.x()});
  }
  return out;
}

Extent turning_extent(const std::array<Vec3, 8>& box) {
  Extent out;
  // Radius and height follow from the corners; the angles are measured from the direction of the
  // centre.
  Vec2 centre = Vec2::Zero();
  double largest = 0;
  for (const Vec3& p : box) {
    centre += p.head<2>() / 8;
    largest = std::max(largest, p.head<2>().norm());
    out.lower[1] = std::min(out.lower[1], p.z());
    out.upper[1] = std::max(out.upper[1], p.z());
  }
  out.upper[0] = largest;
  out.lower[0] = smallest_radius(box);
  // A box that holds the axis has points at every angle.
  if (out.lower[0] <= kAngleSlack * largest) {
    out.lower[0] = out.lower[2] = 0;
    out.upper[2] = kTurn;
    return out;
  }
  // The box is convex and clear of the axis, so it spans less than half a turn about its centre's
  // direction.
  const double middle = std::atan2(centre.y(), centre.x());
  for (const Vec3& p : box) {
    const double cross = centre.x() * p.y() - centre.y() * p.x();
    const double angle = middle + std::atan2(cross, centre.dot(p.head<2>()));
    out.lower[2] = std::min(out.lower[2], angle - kAngleSlack);
    out.upper[2] = std::max(out.upper[2], angle + kAngleSlack);
  }
  return out;
}

// Around asin(growth / radius): what moves the point of a fixed face to one `growth` away.
double angle_growth(double growth, double radius) {
  return radius > growth ? 1.6 * growth / radius : kTurn;
}

class FrameMaker {
 public:
  FrameMaker(const FirstContactQuery& query, double horizon, int resolution)
      : m_resolution(resolution), m_turning(turns(query.motion)) {
    // The image plane lies across the motion; a rotation looks along circles about its axis
    // instead.
    m_frame.kind = query.motion.kind;
    m_frame.origin = m_turning ? query.motion.centre : query.moving.front().world_box.centre();
    const Vec3 w = query.motion.axis, u = w.unitOrthogonal(), v = w.cross(u);
    m_frame.image_from_world << u.transpose(), v.transpose(), w.transpose();
    // Extents come before growth and reach, as they collect the largest coordinate, on which
    // rounding depends.
    for (const Body& body : query.moving) m_moving.push_back(extent(body));
    for (const Body& body : query.fixed) m_fixed.push_back(extent(body));
    m_growth = query.clearance.largest_stop() * 1.002 + kExtentSlack * m_spread;
    // The sweep ends at the horizon; for a turn this is the angle of s, as s = tan(angle / 2).
    m_reach = m_turning ? 2 * std::atan(std::min(horizon, 1.0)) * (1 + kTimeSlack) : horizon;
  }

  ZListFrame make() {
    find_pairs();
    if (m_frame.pairs.empty()) return std::move(m_frame);
    // The rear of all moving bodies becomes depth 0; bodies of a turn are first brought next to
    // each other on the circle.
    m_rear = m_moving[m_frame.moving.front()];
    for (const Index m : m_frame.moving) m_rear.extend(next_to(m_moving[m], m_rear));
    // A whole turn is all there is: the circle is cut open at the rear.
    if (m_turning && m_rear.upper[2] - m_rear.lower[2] > kTurn)
      m_rear.upper[2] = m_rear.lower[2] + kTurn;
    set_window();
    set_depths();
    return std::move(m_frame);
  }

 private:
  static bool turns(const Motion& motion) { return motion.kind == Motion::Kind::Rotation; }

  Extent extent(const Body& body) {
    // A body without faces has an empty extent, and meets nothing.
    if (!body.shape->has_faces()) return {};
    m_spread = std::max(
        {m_spread, body.world_box.max_abs_coordinate(), m_frame.origin.cwiseAbs().maxCoeff()});
    const auto box = corners(body, m_frame.image_from_world, m_frame.origin);
    return m_turning ? turning_extent(box) : straight_extent(box);
  }

  // The same extent, turned by whole turns to be near another one.
  Extent next_to(Extent e, const Extent& other) const {
    if (!m_turning) return e;
    const double middle = 0.5 * (other.lower[2] + other.upper[2]);
    const double shift = kTurn * std::round((middle - 0.5 * (e.lower[2] + e.upper[2])) / kTurn);
    e.lower[2] += shift;
    e.upper[2] += shift;
    return e;
  }

  bool depths_meet(const Extent& a, const Extent& b) const {
    // Growth across the line of sight turns into angle, and more so the nearer the axis is.
    const double growth =
        m_turning ? angle_growth(m_growth, std::max(a.lower[0], b.lower[0]) - m_growth) : m_growth;
    // The moving body sweeps from its rear, less the growth, to its front at the horizon.
    const double low = a.lower[2] - growth, high = a.upper[2] + m_reach + growth;
    if (!m_turning) return b.upper[2] >= low && b.lower[2] <= high;
    // The fixed body is seen once in every turn; the first one that is not behind the rear counts.
    const double first = b.lower[2] + kTurn * std::ceil((low - b.upper[2]) / kTurn);
    return first <= high;
  }

  bool meet(const Extent& a, const Extent& b) const {
    for (int k = 0; k < 2; ++k)
      if (!(a.lower[k] - m_growth <= b.upper[k] && b.lower[k] <= a.upper[k] + m_growth))
        return false;
    return depths_meet(a, b);
  }

  void find_pairs() {
    std::vector<char> fixed(m_fixed.size());
    // Stage 1: only bodies that meet in image and depth until the horizon are drawn.
    for (size_t m = 0; m < m_moving.size(); ++m) {
      for (size_t f = 0; f < m_fixed.size(); ++f) {
        if (!meet(m_moving[m], m_fixed[f])) continue;
        m_frame.pairs.push_back({static_cast<Index>(m), static_cast<Index>(f)});
        fixed[f] = 1;
      }
      if (!m_frame.pairs.empty() && m_frame.pairs.back().moving == static_cast<Index>(m))
        m_frame.moving.push_back(static_cast<Index>(m));
    }
    for (size_t f = 0; f < fixed.size(); ++f)
      if (fixed[f]) m_frame.fixed.push_back(static_cast<Index>(f));
  }

  void set_window() {
    // The image covers where the bodies of a pair overlap, seen along the motion, and no more:
    // pixels are spent where contacts can be.
    Vec2 low = Vec2::Constant(kInfinity), high = -low;
    for (const BodyPair& p : m_frame.pairs) {
      const Extent &a = m_moving[p.moving], &b = m_fixed[p.fixed];
      const Vec2 grown = Vec2::Constant(m_growth);
      low = low.cwiseMin((a.lower.head<2>() - grown).cwiseMax(b.lower.head<2>()) - grown);
      high = high.cwiseMax((a.upper.head<2>() + grown).cwiseMin(b.upper.head<2>()) + grown);
    }
    if (m_turning) low.x() = std::max(low.x(), 0.0);
    // A pixel is at least half the growth wide, as smaller ones would only be grown over, and so
    // wide that float32 tells radii apart.
    const double largest_radius = m_turning ? high.x() / kLargestRadius : 0;
    m_frame.pixel = std::max(
        {(high - low).maxCoeff() / m_resolution, m_growth / 2, largest_radius, 1e-9 * m_spread});
    m_frame.growth = m_growth / m_frame.pixel;
    m_frame.width = num_pixels(high.x() - low.x());
    m_frame.height = num_pixels(high.y() - low.y());
    m_corner = low;
  }

  int num_pixels(double length) const {
    return std::clamp(static_cast<int>(std::ceil(length / m_frame.pixel)), 1, m_resolution);
  }

  void set_depths() {
    // Depths are counted from the rear: pixels of a translation, radians of a turn.
    const double rear = m_rear.lower[2], unit = m_turning ? 1 : m_frame.pixel;
    m_frame.moving_depth = (m_rear.upper[2] - rear) / unit;
    m_frame.reach = m_reach / unit;
    Mat3& rows = m_frame.image_from_world;
    // The frame moves up the axis to the lowest row, and turns until the rear's angle is zero.
    if (m_turning) {
      m_frame.origin += m_corner.y() * rows.row(2).transpose();
      m_frame.first_radius = m_corner.x() / m_frame.pixel;
      const double c = std::cos(rear), s = std::sin(rear);
      const Vec3 x = rows.row(0), y = rows.row(1);
      rows.row(0) = c * x + s * y;
      rows.row(1) = c * y - s * x;
    } else {
      m_frame.origin += rows.transpose() * Vec3(m_corner.x(), m_corner.y(), rear);
    }
  }

  int m_resolution;
  bool m_turning;
  ZListFrame m_frame;
  std::vector<Extent> m_moving, m_fixed;
  Extent m_rear;  // of all paired moving bodies
  Vec2 m_corner = Vec2::Zero();
  double m_spread = 0, m_growth = 0, m_reach = 0;  // metres; m_reach also radians
};

}  // namespace

Affine ZListFrame::pixels_from_object(const Body& body) const {
  const Mat3 m = image_from_world / pixel;
  return {m * body.world_from_object.linear, m * (body.world_from_object.translation - origin)};
}

double ZListFrame::depth_growth(double smallest_radius) const {
  return kind == Motion::Kind::Rotation ? angle_growth(growth, smallest_radius) : growth;
}

double ZListFrame::time_before(double depth) const {
  if (depth <= 0) return 0;
  if (kind == Motion::Kind::Translation) return depth * pixel * (1 - kTimeSlack);
  // Depths of half a turn and more lie beyond every motion, which ends after a quarter.
  return depth < std::numbers::pi ? std::tan(depth / 2) * (1 - kTimeSlack) : kInfinity;
}

double ZListFrame::time_after(double depth) const {
  if (kind == Motion::Kind::Translation) return depth * pixel * (1 + kTimeSlack);
  return depth < std::numbers::pi ? std::tan(depth / 2) * (1 + kTimeSlack) : kInfinity;
}

ZListFrame make_zlist_frame(const FirstContactQuery& query, double horizon, int resolution) {
  ZListFrame none;
  none.kind = query.motion.kind;
  if (query.moving.empty() || query.fixed.empty()) return none;
  return FrameMaker(query, horizon, resolution).make();
}

// Measured by perf/zlists, for software z-lists as for Mesa's renderer.
int zlist_resolution_of_processors(const FirstContactQuery& query) {
  // Many faces pay for smaller pixels: their pixels hold shorter lists, and fewer pairs come out.
  constexpr size_t kManyFaces = 200'000;
  size_t num_faces = 0;
  for (const Body& body : query.moving) num_faces += body.shape->mesh.triangles.size();
  for (const Body& body : query.fixed) num_faces += body.shape->mesh.triangles.size();
  return num_faces < kManyFaces ? 32 : 64;
}

}  // namespace trivet
