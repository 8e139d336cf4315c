// Drafts, drawn while something moves. In large scenes, the static part is cached; from a moving
// camera, small objects are drawn as boxes.
#include <algorithm>
#include <tuple>

#include "gpu/live/key.h"
#include "gpu/live/renderer.h"

namespace trivet {
namespace {

constexpr int kManyToCoarse = 2;  // total triangles per triangle of objects drawn in full

}  // namespace

std::string LiveRenderer::key_of_still(const View& view) {
  std::string key;
  append_key(key, view.options.shadows);
  append_key(key, view.scene.floor);
  append_key(key, view.options.coarse);
  for (const Vec3& v : {view.camera.eye, view.camera.target, view.camera.up})
    for (int i = 0; i < 3; ++i) append_key(key, v[i]);
  append_key(key, view.camera.fov_deg);
  append_key(key, view.camera.height.value_or(0));
  append_key(key, view.camera.cut.value_or(-kInfinity));
  append_key(key, view.options.theme);
  append_key(key, view.options.width), append_key(key, view.options.height);
  for (const LiveObject& object : view.scene.objects) {
    if (object.moving) continue;
    append_key(key, object);
    append_key(key, object.tint);
    append_key(key, object.outlined);
  }
  return key;
}

// Caches a picture of the static objects, with room for the moving ones to move in.
void LiveRenderer::begin_still(const View& view, std::string key, std::optional<LiveStill>& still) {
  const int width = view.options.width, height = view.options.height;
  if (!still || still->width != width || still->height != height) still.emplace(width, height);
  still->key = std::move(key);
  const double room = view.far_depth - view.near_depth;
  still->far_depth = view.far_depth + room;
  still->near_depth = view.camera.height ? view.near_depth - room : view.near_depth;
  if (view.camera.cut) still->near_depth = std::max(still->near_depth, *view.camera.cut);
}

void LiveRenderer::draw_still(const View& view, const LiveStill& still) {
  if (view.options.shadows) draw_shadow_map(view, false);
  if (view.options.coarse) coarsen(view);
  prepare_to_draw_solids();
  bind_target(still.draw, still.width, still.height);
  draw_backdrop(view);
  draw_solid(view, true, false);
}

void LiveRenderer::draw_draft(View& view, Kept& kept) {
  std::string key = key_of_still(view);
  m_work.still_reused = kept.still && kept.still->key == key;
  m_work.still_kept = !m_work.still_reused;
  if (m_work.still_kept) begin_still(view, std::move(key), kept.still);
  const LiveStill& still = *kept.still;
  view.near_depth = still.near_depth, view.far_depth = still.far_depth;
  view.clip_from_world = clip_from_world(view.camera, view.axes, view.near_depth, view.far_depth);
  cull(view);
  if (m_work.still_kept) draw_still(view, still);
  copy_target(still.draw, kept.draft->draw, still.width, still.height,
              GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  prepare_to_draw_solids();
  bind_target(kept.draft->draw, still.width, still.height);
  draw_solid(view, false, true);
}

// Draws outlined objects and the largest ones in full, as far as that is quick.
void LiveRenderer::coarsen(const View& view) {
  struct Candidate {
    bool outlined;
    double size;
    Instance* instance;
  };
  std::vector<Candidate> candidates;
  for (Instance& instance : m_instances) {
    if (!instance.seen || instance.object->moving || instance.object->opacity < 1) continue;
    const double size = (instance.corners[7] - instance.corners[0]).norm();
    const double depth = view.camera.height ? 1 : std::max(instance.depth, 1e-3 * size);
    candidates.push_back({instance.object->outlined, size / depth, &instance});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) {
                     return std::tie(b.outlined, b.size) < std::tie(a.outlined, a.size);
                   });
  std::int64_t num_triangles = 0;
  for (const Candidate& candidate : candidates) {
    const UploadedMesh& mesh = *candidate.instance->mesh;
    num_triangles += mesh.num_corners / 3;
    if (num_triangles > m_many_triangles / kManyToCoarse) draw_as_box(*candidate.instance);
  }
}

void LiveRenderer::draw_as_box(Instance& instance) {
  const UploadedMesh& mesh = *instance.mesh;
  Affine pose = instance.object->world_from_object;
  pose.translation = pose.apply(mesh.box.centre());
  pose.linear = pose.linear * mesh.box.half_extent().asDiagonal();
  LiveColour& tint = instance.tint;
  for (std::size_t i = 0; i < 3; ++i)
    tint[i] = (1 - tint[3]) * mesh.mean_colour[i] + tint[3] * tint[i];
  tint[3] = 1;
  instance.placement = place_mesh(m_box, pose, m_frame);
  instance.mesh = &m_box;
  ++m_work.objects_as_boxes;
}

}  // namespace trivet
