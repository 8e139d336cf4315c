#include "raster/labels/face_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

// Projected corners are off by less, within the largest window.
constexpr double kPixelMargin = 1e-3;  // pixels
// Spans up to this are shrunk pixel by pixel, longer ones by division first.
constexpr int kShortSpan = 6;

PixelPlane pixel_plane(const Vec3& n, const PinholeCamera& camera) {
  const double a = n.x() / camera.fx, b = n.y() / camera.fy;
  return {a, b, n.z() - (camera.cx * a + camera.cy * b)};
}

PixelPlane operator*(double sign, const PixelPlane& p) {
  return {sign * p.a, sign * p.b, sign * p.c};
}

// The end of [lower, upper] towards which the pixels go that are at least `value`, or at most.
int first_pixel(double value, int lower, int upper) {
  return value <= lower ? lower : value > upper ? upper + 1 : static_cast<int>(std::ceil(value));
}
int last_pixel(double value, int lower, int upper) {
  return value >= upper ? upper : value < lower ? lower - 1 : static_cast<int>(std::floor(value));
}

PixelRange pixels_of(const ImageBox& box, const PixelRange& window) {
  return {first_pixel(box.x0 - kPixelMargin, window.x0, window.x1),
          first_pixel(box.y0 - kPixelMargin, window.y0, window.y1),
          last_pixel(box.x1 + kPixelMargin, window.x0, window.x1),
          last_pixel(box.y1 + kPixelMargin, window.y0, window.y1)};
}

// Cuts [lower, upper] to where the function is not negative: a half-line, as rounding keeps order.
void cut_span(const PixelPlane& plane, double row, int& lower, int& upper) {
  const auto outside = [&](int x) { return plane.a * x + row < 0; };
  // A long span is cut by division, with a pixel to spare; the exact test follows.
  if (upper - lower > kShortSpan && plane.a != 0) {
    const double root = -row / plane.a;
    if (plane.a > 0)
      lower = std::max(lower, first_pixel(root - 1, lower, upper));
    else
      upper = std::min(upper, last_pixel(root + 1, lower, upper));
  }
  // The last pixels are tested by the edge's own function: no gap opens beside a neighbour.
  while (lower <= upper && outside(lower)) ++lower;
  while (lower <= upper && outside(upper)) --upper;
}

}  // namespace

void ImageBox::extend(double x, double y) {
  x0 = std::min(x0, x), x1 = std::max(x1, x);
  y0 = std::min(y0, y), y1 = std::max(y1, y);
}

void ImageBox::extend(const ImageBox& box) {
  x0 = std::min(x0, box.x0), x1 = std::max(x1, box.x1);
  y0 = std::min(y0, box.y0), y1 = std::max(y1, box.y1);
}

ImageBox image_box(const Triangle& corners, const PinholeCamera& camera) {
  ImageBox box;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &p = corners[i], &q = corners[(i + 1) % 3];
    if (p.z() > 0)
      box.extend(camera.fx * p.x() / p.z() + camera.cx, camera.fy * p.y() / p.z() + camera.cy);
    if ((p.z() > 0) == (q.z() > 0)) continue;
    // Towards z = 0 the image of the edge goes to infinity.
    const Vec3 &front = p.z() > 0 ? p : q, &back = p.z() > 0 ? q : p;
    const Vec2 side = front.head<2>() * -back.z() + back.head<2>() * front.z();
    if (side.x() > 0) box.x1 = kInfinity;
    if (side.x() < 0) box.x0 = -kInfinity;
    if (side.y() > 0) box.y1 = kInfinity;
    if (side.y() < 0) box.y0 = -kInfinity;
  }
  return box;
}

std::optional<FaceView> view_face(const Triangle& corners, const PinholeCamera& camera,
                                  const PixelRange& window) {
  const Vec3 &p = corners[0], &q = corners[1], &r = corners[2];
  const ImageBox image = image_box(corners, camera);
  if (image.empty()) return std::nullopt;
  FaceView face;
  face.box = pixels_of(image, window);
  if (face.box.empty()) return std::nullopt;
  // The plane of the face gives its depth at each pixel; a face seen edge-on has none.
  const Vec3 normal = (q - p).cross(r - p);
  const double offset = normal.dot(p);
  if (!normal.allFinite() || !std::isfinite(offset) || offset == 0) return std::nullopt;
  // Signs are turned so that inside is positive whichever way the face is wound.
  const double sign = offset > 0 ? 1 : -1;
  for (int i = 0; i < 3; ++i)
    face.edges[i] = sign * pixel_plane(corners[i].cross(corners[(i + 1) % 3]), camera);
  face.slope = sign * pixel_plane(normal, camera);
  face.offset = sign * offset;
  face.nearest = std::min({p.z(), q.z(), r.z()});
  face.farthest = std::max({p.z(), q.z(), r.z()});
  return face;
}

std::pair<int, int> covered_span(const FaceView& face, int y) {
  int lower = face.box.x0, upper = face.box.x1;
  for (const PixelPlane& edge : face.edges) cut_span(edge, edge.row(y), lower, upper);
  return {lower, upper};
}

}  // namespace trivet
