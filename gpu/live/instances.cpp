// The objects of a view: their meshes, places, depths, and which of them are seen.
#include <algorithm>
#include <cmath>

#include "gpu/live/renderer.h"

namespace trivet {
namespace {

constexpr double kNearestOfFarthest = 2e-4;  // nearer geometry is clipped
constexpr double kSmallest = 0.5;            // px; smaller objects are left out

float linear_from_srgb(float x) {
  return x > 0.04045f ? std::pow((x + 0.055f) / 1.055f, 2.4f) : x / 12.92f;
}

LiveColour linear_from_srgb(const LiveColour& colour) {
  return {linear_from_srgb(colour[0]), linear_from_srgb(colour[1]), linear_from_srgb(colour[2]),
          colour[3]};
}

}  // namespace

const UploadedMesh& LiveRenderer::mesh_of(const std::shared_ptr<const Model>& model) {
  KnownMesh& known = m_meshes[model.get()];
  if (known.model.lock() != model) {  // unknown, or a different model at the same address
    std::size_t texture_bytes = 0;
    for (const auto& [other, its] : m_meshes) texture_bytes += its.mesh.texture_bytes();
    known = {model, upload_mesh(picture_mesh(*model), texture_bytes)};
    ++m_work.meshes_sent;
  }
  return known.mesh;
}

void LiveRenderer::place_instances(const LiveScene& scene) {
  std::erase_if(m_meshes, [](const auto& known) { return known.second.model.expired(); });
  m_instances.clear();
  m_num_triangles = 0;
  Aabb all, still;
  for (const LiveObject& object : scene.objects) {
    const UploadedMesh& mesh = mesh_of(object.model);
    const Affine& pose = object.world_from_object;
    if (mesh.empty() || !pose.linear.allFinite() || !pose.translation.allFinite()) continue;
    Instance instance;
    instance.object = &object, instance.mesh = &mesh;
    instance.tint = linear_from_srgb(object.tint);
    for (int i = 0; i < 8; ++i) {
      instance.corners[i] = pose.apply(box_corner(mesh.box, i));
      all.extend(instance.corners[i]);
      if (!object.moving) still.extend(instance.corners[i]);
    }
    m_num_triangles += mesh.num_corners / 3;
    m_instances.push_back(instance);
  }
  // The same while some objects move: what is drawn once more covers what it was drawn as before.
  m_frame = frame_of_box(still.empty() ? all : still);
  for (Instance& instance : m_instances)
    instance.placement = place_mesh(*instance.mesh, instance.object->world_from_object, m_frame);
}

void LiveRenderer::find_depth_range(View& view) const {
  double nearest = kInfinity, farthest = -kInfinity;
  const auto extend = [&](const Vec3& p) {
    const double depth = depth_of(p, view.camera, view.axes);
    nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
  };
  for (const Instance& instance : m_instances)
    for (const Vec3& corner : instance.corners) extend(corner);
  for (int i = 0; i < 4; ++i)
    extend(view.floor_centre + view.floor_radius * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, 0));
  const LiveOverlay& overlay =
      view.scene.overlay;  // lines and points are never clipped by near or far planes
  for (const LiveTriangle& triangle : overlay.triangles)
    for (const Vec3& corner : triangle.corners) extend(corner);
  const double room = 0.02 * (farthest - nearest) + 0.01 * view.reach();
  nearest -= room, farthest += room;
  if (!view.camera.height) {
    farthest = std::max(farthest, view.reach());
    nearest = std::max(nearest, kNearestOfFarthest * farthest);
  }
  if (view.camera.cut && *view.camera.cut > nearest) {
    nearest = *view.camera.cut;
    farthest = std::max(farthest, nearest + room);
  }
  view.near_depth = nearest, view.far_depth = farthest;
}

void LiveRenderer::cull(const View& view) {
  for (Instance& instance : m_instances) {
    const auto& corners = instance.corners;
    const Vec3 middle = 0.5 * (corners[0] + corners[7]);
    instance.depth = depth_of(middle, view.camera, view.axes);
    const double size = (corners[7] - corners[0]).norm();
    const double pixel = 2 * view.axes.up.norm() / view.options.height *
                         (view.camera.height ? 1 : std::max(instance.depth, 0.0));
    instance.seen = size >= kSmallest * pixel && !out_of_sight(corners, view.clip_from_world);
    ++(instance.seen ? m_work.objects_drawn : m_work.objects_culled);
  }
  // Front to back, for early depth tests.
  std::stable_sort(m_instances.begin(), m_instances.end(),
                   [](const Instance& a, const Instance& b) { return a.depth < b.depth; });
}

}  // namespace trivet
