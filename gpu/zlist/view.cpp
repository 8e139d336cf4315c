#include "gpu/zlist/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivet {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
/// Rounding of a float32; twice that of rounding to nearest.
constexpr double kRounding = 1.2e-7;
/// Less certain samples are rejected, pixels. Larger: pairs near contact get no upper bound;
/// smaller: steep faces get none.
constexpr double kSampleError = 1e-3;

// Largest distance of true positions from computed ones, per coordinate, in pixels: vertices, the
// matrix, three products and their sum are rounded, and later differences of positions.
Vec3 place_error(const Affine& pixels, const Vec3& half_extent) {
  return kRounding *
         (8 * pixels.linear.cwiseAbs() * half_extent + 6 * pixels.translation.cwiseAbs());
}

ZListBody make_body(const Body& body, const ZListFrame& frame, double growth) {
  const Aabb& box = body.shape->box;
  // Positions are sent about the box's centre, so that the matrix places that instead of the
  // origin.
  Affine pixels = frame.pixels_from_object(body);
  pixels.translation = pixels.apply(box.centre());
  const Vec3 error = place_error(pixels, box.half_extent());
  ZListBody out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out.rows[4 * r + c] = static_cast<float>(pixels.linear(r, c));
    out.rows[4 * r + 3] = static_cast<float>(pixels.translation[r]);
  }
  const bool turning = frame.kind == Motion::Kind::Rotation;
  // Across the image the growth joins the error; a turn mixes all three coordinates.
  const double across = turning ? error.sum() : std::max(error.x(), error.y());
  out.blur = static_cast<float>(1.00001 * (across + growth) + 1e-6);
  out.depth_blur = static_cast<float>(1.00001 * (error.z() + growth) + 1e-6);
  return out;
}

float blur_of(const ZListBody& body) { return std::max(body.blur, body.depth_blur); }

// Set by the fixed body with the best resolution: farther, larger ones give no samples.
float sample_error(const ZListView& view, const ZListFrame& frame) {
  const auto less = [](const ZListBody& a, const ZListBody& b) { return blur_of(a) < blur_of(b); };
  const float moving = blur_of(*std::max_element(view.moving.begin(), view.moving.end(), less));
  const float fixed = blur_of(*std::min_element(view.fixed.begin(), view.fixed.end(), less));
  const double error = kSampleError + 8 * std::max(moving, fixed);
  if (view.kind == Motion::Kind::Translation) return static_cast<float>(error);
  return static_cast<float>(1e-5 + error / (frame.first_radius + frame.width));
}

}  // namespace

ZListView make_view(const FirstContactQuery& query, const ZListFrame& frame,
                    ZListMeshCache& meshes) {
  ZListView view;
  view.kind = frame.kind;
  view.width = frame.width;
  view.height = frame.height;
  view.first_radius = static_cast<float>(frame.first_radius);
  view.horizon = static_cast<float>(1.00001 * frame.reach + 1e-5);
  // The circle of a turn is cut in the middle of the angles that no moving face has.
  if (frame.kind == Motion::Kind::Rotation) {
    view.period = static_cast<float>(kTurn);
    view.first_depth = static_cast<float>(-0.5 * std::max(0.0, kTurn - frame.moving_depth));
  }
  // Faces of all bodies are numbered in one row, moving ones first.
  std::uint32_t num_faces = 0;
  const auto add = [&](std::vector<ZListBody>& out, const Body& body, Index i, double growth) {
    const GpuMesh* mesh = meshes.get(*body.shape);
    if (!mesh) return false;
    out.push_back(make_body(body, frame, growth));
    out.back().mesh = mesh;
    out.back().body = i;
    out.back().first_face = num_faces;
    num_faces += static_cast<std::uint32_t>(mesh->num_faces);
    return true;
  };
  bool fits = true;
  for (const Index i : frame.moving)
    fits = fits && add(view.moving, query.moving[i], i, frame.growth);
  for (const Index i : frame.fixed) fits = fits && add(view.fixed, query.fixed[i], i, 0);
  // A view without fixed bodies tells that the meshes did not fit.
  if (!fits) view.fixed.clear();
  if (fits) view.sample_error = sample_error(view, frame);
  return view;
}

}  // namespace trivet
