// Triangles of a rotation, in the image of radius and height; the rest of TriangleRaster.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "raster/zlist/angles.h"
#include "raster/zlist/triangle_raster.h"

// r, h: radius and height, pixels of the frame. phi: angle. k: distance of a plane's line from the
// axis, in the plane at height h: r cos(phi - phi_n) = k(h).

namespace trivet {
namespace {

constexpr double kWide = 1.5;           // radians; beyond, an axis inside cannot be excluded
constexpr double kLongestPiece = 0.5;   // radians
constexpr double kLargestBulge = 0.25;  // pixels
constexpr double kBlock = 1;            // pixels; smaller pieces are not bisected
constexpr double kTinyRadius = 1e-3;    // pixels; angles are meaningless below
constexpr double kCentreError = 1e-7;   // of the cosine of a centre
constexpr int kMostPieces = 1 << 18;
constexpr double kFar = 20;  // beyond all angles

double angle_between(const Vec3& a, const Vec3& b) {
  return fast_atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
}

// The plane of a piece, for angles within its own.
class TurningPlane {
 public:
  TurningPlane(const Triangle& c, double largest_radius) {
    const Vec3 n = (c[1] - c[0]).cross(c[2] - c[0]);
    const double squared = std::max(
        {(c[1] - c[0]).squaredNorm(), (c[2] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm()});
    const double across = n.head<2>().norm();
    // A plane across the axis has no angle; a thin piece has no plane.
    m_usable = n.norm() > 1e-5 * squared && across > 1e-4 * n.norm();
    if (!m_usable) return;
    m_normal_angle = fast_atan2(n.y(), n.x());
    m_slope = -n.z() / across;
    // The line of the plane at height h is at the distance k(h) from the axis, which is linear.
    m_height = c[0].z();
    m_k = n.head<2>().dot(c[0].head<2>()) / across;
    m_error = 1e-9 * (largest_radius + std::sqrt(squared)) * (1 + std::abs(m_slope));
  }

  bool usable() const { return m_usable; }
  double normal_angle() const { return m_normal_angle; }
  double k(double h) const { return m_k + m_slope * (h - m_height); }
  double error() const { return m_error; }
  double slope() const { return std::abs(m_slope); }

 private:
  bool m_usable;
  double m_normal_angle = 0, m_slope = 0, m_height = 0, m_k = 0, m_error = 0;
};

// Cosines over a cell: k in [k0, k1] over r in [r0, r1].
struct Cosines {
  double low, high;
};

Cosines cosines(double k0, double k1, double r0, double r1) {
  // The extreme cosines are at the nearest or farthest radius, depending on the sign of k.
  const double inf = kInfinity;
  const double low = k0 > 0 ? k0 / r1 : (r0 > 0 ? k0 / r0 : (k0 < 0 ? -inf : 0));
  const double high = k1 < 0 ? k1 / r1 : (r0 > 0 ? k1 / r0 : (k1 > 0 ? inf : 0));
  return {low, high};
}

// Hull of what +-[b0, b1] mod 2 pi has in common with [q0, q1], -pi <= q0 <= pi.
struct Hull {
  double lower = kInfinity, upper = -kInfinity;
  void add(double b0, double b1, double q0, double q1) {
    const double low = std::max(b0, q0), high = std::min(b1, q1);
    if (low > high) return;
    lower = std::min(lower, low);
    upper = std::max(upper, high);
  }
};

Hull angles_in_cell(const Cosines& c, double q0, double q1) {
  Hull hull;
  if (c.low > 1 || c.high < -1) return hull;
  // A cosine has two angles about the normal, on both sides of it, and those a turn farther.
  const double b0 = fast_acos(std::min(c.high, 1.0)) - kAngleError;
  const double b1 = fast_acos(std::max(c.low, -1.0)) + kAngleError;
  hull.add(b0, b1, q0, q1);
  hull.add(-b1, -b0, q0, q1);
  hull.add(kTurn - b1, kTurn - b0, q0, q1);
  return hull;
}

// The only angle in [q0, q1] with this cosine; NaN if there is none or more than one.
double only_angle(double cosine, double q0, double q1) {
  if (!(std::abs(cosine) < 0.9999)) return kNotMet;  // errors grow without bound
  const double b = fast_acos(cosine);
  double found = kNotMet;
  int num = 0;
  for (const double x : {b, -b, kTurn - b}) {
    // The error may put an angle just outside the piece's own.
    if (x < q0 - 1e-5 || x > q1 + 1e-5) continue;
    found = x;
    ++num;
  }
  return num == 1 ? found : kNotMet;
}

}  // namespace

// A chord of arc x is below its circle by r (1 - cos(x / 2)) <= r x^2 / 8.
double TriangleRaster::Piece::bulge() const {
  const double arc = last_angle - first_angle;
  return largest_radius * arc * arc / 8;
}

TriangleRaster::Piece TriangleRaster::make_piece(const Triangle& c) const {
  Piece out;
  out.corners = c;
  // Radii of the corners bound those of the piece, but for the bulge of its sides.
  for (int k = 0; k < 3; ++k) out.radius[k] = c[k].head<2>().norm();
  out.largest_radius = std::max({out.radius[0], out.radius[1], out.radius[2]});
  const double least = std::min({out.radius[0], out.radius[1], out.radius[2]});
  out.size = std::sqrt(std::max(
      {(c[1] - c[0]).squaredNorm(), (c[2] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm()}));
  out.smallest_radius = std::max(0.0, least - out.size);
  // A piece that is wide or at the axis has no range of angles.
  const double a = angle_between(c[0], c[1]), b = angle_between(c[0], c[2]);
  out.narrow =
      least > kTinyRadius && std::abs(a) < kWide && std::abs(b) < kWide && std::abs(a - b) < kWide;
  out.first_angle = out.last_angle = 0;
  if (!out.narrow) return out;
  // The first corner's angle is the origin; the others are measured from it, so that no cut is
  // crossed.
  const double start =
      wrapped(fast_atan2(c[0].y(), c[0].x()), m_view.frame->moving_depth / 2 - kPi);
  out.first_angle = start + std::min({0.0, a, b}) - 2 * kAngleError;
  out.last_angle = start + std::max({0.0, a, b}) + 2 * kAngleError;
  out.smallest_radius = std::max(out.smallest_radius, least - out.bulge());
  return out;
}

bool TriangleRaster::outside(const Piece& p) const {
  const double margin = kRoundingPixels + m_growth, scale = m_view.scale;
  const double left = m_view.frame->first_radius + m_view.column;
  const auto [low, high] = std::minmax({p.corners[0].z(), p.corners[1].z(), p.corners[2].z()});
  return (p.largest_radius - left) * scale < -margin ||
         (p.smallest_radius - left) * scale > m_view.width + margin ||
         (high - m_view.row) * scale < -margin ||
         (low - m_view.row) * scale > m_view.height + margin;
}

template <class F>
void TriangleRaster::for_each_copy(const Piece& p, F f) const {
  const double growth = m_view.frame->depth_growth(p.smallest_radius);
  for_each_copy(p.first_angle - growth, p.last_angle + growth, f);
}

bool TriangleRaster::draw_turning(const Triangle& corners, SpanSink& sink) {
  std::vector<Triangle> open{corners};
  for (int num = 0; !open.empty(); ++num) {
    // Near the axis a face may need more pieces than it is worth.
    if (num > kMostPieces) return false;
    const Piece p = make_piece(open.back());
    open.pop_back();
    if (outside(p)) continue;
    // Pieces whose angles are never within the sweep are dropped.
    bool matters = !p.narrow;
    if (p.narrow) for_each_copy(p, [&](double) { matters = true; });
    if (!matters) continue;
    const double scale = m_view.scale;
    // A piece is drawn once its chords stay close to their circles.
    if (p.narrow && p.bulge() * scale <= kLargestBulge &&
        p.last_angle - p.first_angle <= kLongestPiece) {
      for_each_copy(p, [&](double shift) { draw_narrow(p, shift, sink); });
    } else if (p.size * scale <= kBlock) {
      // Small pieces fill their block; without known angles at all depths.
      if (p.narrow)
        for_each_copy(p, [&](double shift) {
          draw_block(p, {p.first_angle + shift, p.last_angle + shift}, sink);
        });
      else
        draw_block(p, {-kFar, kFar}, sink);
    } else {
      int longest = 0;
      const Triangle& c = p.corners;
      for (int k = 1; k < 3; ++k)
        if ((c[(k + 1) % 3] - c[k]).squaredNorm() >
            (c[(longest + 1) % 3] - c[longest]).squaredNorm())
          longest = k;
      const Vec3 &a = c[longest], &b = c[(longest + 1) % 3], &apex = c[(longest + 2) % 3];
      // The rest is bisected at the longest edge.
      const Vec3 middle = 0.5 * (a + b);
      open.push_back({a, middle, apex});
      open.push_back({middle, b, apex});
    }
  }
  return true;
}

void TriangleRaster::draw_block(const Piece& p, Range angles, SpanSink& sink) {
  // The block of a piece holds all radii and heights that it may have.
  const double scale = m_view.scale, margin = kRoundingPixels + m_growth;
  const double left = m_view.frame->first_radius + m_view.column;
  const auto [low, high] = std::minmax({p.corners[0].z(), p.corners[1].z(), p.corners[2].z()});
  const auto pixel = [&](double x, int count) {
    return static_cast<int>(std::clamp(std::floor(x), -1.0, static_cast<double>(count)));
  };
  const int x0 = std::max(0, pixel((p.smallest_radius - left) * scale - margin, m_view.width));
  const int x1 =
      std::min(m_view.width - 1, pixel((p.largest_radius - left) * scale + margin, m_view.width));
  const int y0 = std::max(0, pixel((low - m_view.row) * scale - margin, m_view.height));
  const int y1 =
      std::min(m_view.height - 1, pixel((high - m_view.row) * scale + margin, m_view.height));
  if (x0 > x1) return;
  // Its depths are the same in all pixels.
  for (int i = x0; i <= x1; ++i) {
    const double grown = 1e-6 + (m_view.moving ? m_angle_growth[i] : 0);
    m_lower[i] = static_cast<float>(angles.lower - grown);
    m_upper[i] = static_cast<float>(angles.upper + grown);
    m_centre[i] = kNotMet;
  }
  for (int row = y0; row <= y1; ++row) emit(row, {x0, x1}, 0, sink);
}

void TriangleRaster::draw_narrow(const Piece& piece, double shift, SpanSink& sink) {
  const double scale = m_view.scale, bulge = piece.bulge() * scale;
  const double left = m_view.frame->first_radius + m_view.column;
  // The bulge bends the image towards the axis: half of it moves the piece, half of it widens the
  // pixels.
  const double half_y = 0.5 + kRoundingPixels + m_growth, half_x = half_y + bulge / 2;
  std::array<Vec2, 3> p;
  for (int k = 0; k < 3; ++k)
    p[k] = {(piece.radius[k] - left) * scale - bulge / 2,
            (piece.corners[k].z() - m_view.row) * scale};
  const Coverage cover(p, half_x, half_y, m_view.width, m_view.height);
  if (cover.is_empty()) return;
  // Angles in a pixel follow from the plane, where it is known well enough.
  const TurningPlane plane(piece.corners, piece.largest_radius);
  const double base = plane.normal_angle();
  const double q0 = wrapped(piece.first_angle - base, -kPi);
  const double q1 = q0 + piece.last_angle - piece.first_angle;
  const double offset = piece.first_angle - q0 + shift;
  // Each row has one height, and so one line of the plane.
  for (int row = cover.first_row(); row <= cover.last_row(); ++row) {
    const Coverage::Columns columns = cover.touched(row);
    if (columns.first > columns.last) continue;
    const Coverage::Columns in = cover.inside(row, 2 * bulge + kRoundingPixels);
    const double h = m_view.row + (row + 0.5) / scale, middle = plane.k(h);
    const double spread = plane.slope() * half_y / scale + plane.error();
    for (int i = columns.first; i <= columns.last; ++i) {
      // Over the pixel's radii the cosine spans an interval, and with it the angle.
      const double r = left + (i + 0.5) / scale, half = half_y / scale;
      Hull hull{q0, q1};
      double centre = kNotMet;
      if (plane.usable()) {
        hull =
            angles_in_cell(cosines(middle - spread, middle + spread, r - half, r + half), q0, q1);
        // The centre's angle is certain only inside, and if no other angle fits.
        if (i >= in.first && i <= in.last && plane.error() < kCentreError * r)
          centre = only_angle(middle / r, q0, q1);
      }
      const double grown = 1e-6 + (m_view.moving ? m_angle_growth[i] : 0);
      m_lower[i] = static_cast<float>(hull.lower + offset - grown);
      m_upper[i] = static_cast<float>(hull.upper + offset + grown);
      m_centre[i] = static_cast<float>(centre + offset);
    }
    emit(row, columns, 1e-5F, sink);
  }
}

}  // namespace trivet
