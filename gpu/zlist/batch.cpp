#include "gpu/zlist/batch.h"

#include <algorithm>
#include <bit>
#include <map>

namespace trivet {
namespace {

constexpr std::uint32_t kFarRight = 0x7fffffff;  // of every pixel

glsl::Instance make_instance(const ZListBody& body, std::size_t layer) {
  const std::array<float, 12>& m = body.rows;
  return {{{m[0], m[1], m[2], m[3]}, {m[4], m[5], m[6], m[7]}, {m[8], m[9], m[10], m[11]}},
          body.blur,
          body.depth_blur,
          body.first_face,
          static_cast<std::uint32_t>(layer)};
}

glsl::Layer make_layer(const ZListView& v) {
  const std::uint32_t horizon = ordered(v.horizon);
  glsl::Layer out{};
  out.size = {v.width, v.height};
  out.first_radius = v.first_radius;
  out.sample_error = v.sample_error;
  out.period = v.period;
  out.first_depth = v.first_depth;
  out.upper = out.lower = horizon;
  out.low_x = out.low_y = kFarRight;
  out.most_handed_over = v.most_handed_over;
  return out;
}

std::vector<ZListJob> add_jobs(std::span<const ZListView> views,
                               std::vector<ZListBody> ZListView::*bodies,
                               std::vector<glsl::Instance>& out) {
  std::map<const GpuMesh*, std::vector<glsl::Instance>> of_mesh;
  for (std::size_t layer = 0; layer < views.size(); ++layer)
    for (const ZListBody& b : views[layer].*bodies)
      of_mesh[b.mesh].push_back(make_instance(b, layer));
  std::vector<ZListJob> jobs;
  for (const auto& [mesh, instances] : of_mesh) {
    jobs.push_back({mesh, static_cast<GLuint>(out.size()), static_cast<GLuint>(instances.size())});
    out.insert(out.end(), instances.begin(), instances.end());
  }
  return jobs;
}

}  // namespace

std::uint32_t ordered(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

float unordered(std::uint32_t key) {
  return std::bit_cast<float>((key & 0x80000000u) != 0 ? key & 0x7fffffffu : ~key);
}

ZListBatch make_batch(std::span<const ZListView> views) {
  ZListBatch out;
  out.kind = views.front().kind;
  out.moving = add_jobs(views, &ZListView::moving, out.instances);
  out.fixed = add_jobs(views, &ZListView::fixed, out.instances);
  for (const ZListView& v : views) {
    out.layers.push_back(make_layer(v));
    out.width = std::max(out.width, static_cast<GLuint>(v.width));
    out.height = std::max(out.height, static_cast<GLuint>(v.height));
    out.layer_pixels = std::max(out.layer_pixels, static_cast<GLuint>(v.width * v.height));
  }
  return out;
}

}  // namespace trivet
