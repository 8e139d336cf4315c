#include "raster/labels/labels.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "core/base/bad_input.h"
#include "core/base/parallel.h"
#include "raster/labels/silhouette.h"

namespace trivet {
namespace {

constexpr int kLabelRows = 16;
constexpr std::size_t kChunkFaces = 1 << 14;

// A face that may cover a pixel, and the rows of these.
struct SeenFace {
  std::uint32_t object, face;
  int y0, y1;
};

// Nearest face of a pixel so far.
struct NearestFace {
  double depth = kInfinity;
  std::uint32_t object = 0, face = 0;
  bool hit() const { return depth < kInfinity; }
};

struct FaceChunk {
  std::uint32_t object;
  std::size_t first, last;
};

class LabelRenderer {
 public:
  LabelRenderer(const PictureScene& scene, const PinholeCamera& camera, const LabelOptions& options)
      : m_scene(scene),
        m_camera(camera),
        m_options(options),
        m_views(seen_objects(scene, camera)),
        m_picture{0, 0, camera.width - 1, camera.height - 1} {}

  Labels render();

 private:
  void find_faces();
  void draw_band(int band);
  void draw_face(const SeenFace& seen, const PixelRange& rows,
                 std::vector<NearestFace>& nearest) const;
  void finish_row(int y, const NearestFace* nearest);
  std::array<float, 3> normal_of(const NearestFace& nearest, const Vec3& ray) const;
  void add_visible(std::vector<ObjectLabel>& objects) const;
  void measure_object(std::size_t object);

  const PictureScene& m_scene;
  const PinholeCamera& m_camera;
  const LabelOptions& m_options;
  std::vector<SeenObject> m_views;
  PixelRange m_picture;
  std::vector<std::vector<SeenFace>> m_faces;  // in the order of the scene
  Labels m_labels;
};

void LabelRenderer::find_faces() {
  // Faces are looked at in chunks of equal size, in parallel, and kept in the scene's order.
  std::vector<FaceChunk> chunks;
  for (std::size_t o = 0; o < m_views.size(); ++o) {
    const std::size_t count = m_scene.objects[o].mesh->triangles.size();
    for (std::size_t first = 0; first < count; first += kChunkFaces)
      chunks.push_back(
          {static_cast<std::uint32_t>(o), first, std::min(count, first + kChunkFaces)});
  }
  m_faces.resize(chunks.size());
  in_parallel(chunks.size(), [&](std::size_t i) {
    const auto& [object, first, last] = chunks[i];
    for (std::size_t f = first; f < last; ++f)
      if (const auto face = view_face(m_views[object].triangle(f), m_camera, m_picture))
        m_faces[i].push_back({object, static_cast<std::uint32_t>(f), face->box.y0, face->box.y1});
  });
}

void LabelRenderer::draw_face(const SeenFace& seen, const PixelRange& rows,
                              std::vector<NearestFace>& nearest) const {
  const auto face = view_face(m_views[seen.object].triangle(seen.face), m_camera, rows);
  if (!face) return;
  for (int y = face->box.y0; y <= face->box.y1; ++y) {
    const auto [x0, x1] = covered_span(*face, y);
    NearestFace* const row = nearest.data() + std::size_t(y - rows.y0) * m_camera.width;
    const double slope = face->slope.row(y);
    // Equal depths go to the face that comes first in the scene: results do not depend on threads.
    for (int x = x0; x <= x1; ++x) {
      const double depth = face->depth(x, slope);
      if (depth > 0 && depth < row[x].depth) row[x] = {depth, seen.object, seen.face};
    }
  }
}

void LabelRenderer::draw_band(int band) {
  PixelRange rows = m_picture;
  rows.y0 = band * kLabelRows;
  rows.y1 = std::min(m_picture.y1, rows.y0 + kLabelRows - 1);
  std::vector<NearestFace> nearest(std::size_t(kLabelRows) * m_camera.width);
  // Every band draws all faces that reach it: bands share nothing.
  for (const std::vector<SeenFace>& chunk : m_faces)
    for (const SeenFace& seen : chunk)
      if (seen.y0 <= rows.y1 && seen.y1 >= rows.y0) draw_face(seen, rows, nearest);
  for (int y = rows.y0; y <= rows.y1; ++y)
    finish_row(y, nearest.data() + std::size_t(y - rows.y0) * m_camera.width);
}

std::array<float, 3> LabelRenderer::normal_of(const NearestFace& nearest, const Vec3& ray) const {
  const Triangle t = m_views[nearest.object].triangle(nearest.face);
  Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized();
  // Normals face the camera.
  if (n.dot(ray) > 0) n = -n;
  return {float(n.x()), float(n.y()), float(n.z())};
}

void LabelRenderer::finish_row(int y, const NearestFace* nearest) {
  // Height of a point at depth t over the floor: eye.z + t (up . ray).
  const Vec3 up = m_camera.camera_from_world.col(2);
  const bool floor = m_scene.floor && m_camera.eye.z() > 0;
  for (int x = 0; x < m_camera.width; ++x) {
    const Vec3 ray((x - m_camera.cx) / m_camera.fx, (y - m_camera.cy) / m_camera.fy, 1);
    const double fall = -up.dot(ray);
    const double to_floor = floor && fall > 0 ? m_camera.eye.z() / fall : kInfinity;
    const std::size_t i = std::size_t(y) * m_camera.width + x;
    // The nearest of object and floor is seen.
    if (nearest[x].hit() && nearest[x].depth <= to_floor) {
      m_labels.depth[i] = static_cast<float>(nearest[x].depth);
      m_labels.instances[i] = static_cast<std::uint16_t>(nearest[x].object + 1);
      if (m_options.normals) m_labels.normals[i] = normal_of(nearest[x], ray);
    } else if (to_floor < kInfinity) {
      m_labels.depth[i] = static_cast<float>(to_floor);
      m_labels.instances[i] = kFloorInstance;
      if (m_options.normals) m_labels.normals[i] = {float(up.x()), float(up.y()), float(up.z())};
    }
  }
}

void LabelRenderer::add_visible(std::vector<ObjectLabel>& objects) const {
  for (int y = 0; y < m_labels.height; ++y)
    for (int x = 0; x < m_labels.width; ++x) {
      const std::uint16_t id = m_labels.instances[std::size_t(y) * m_labels.width + x];
      if (id == kNoInstance || id == kFloorInstance) continue;
      ObjectLabel& object = objects[id - 1];
      LabelBox& box = object.visible_box;
      if (object.num_visible++ == 0) box = {double(x), double(y), double(x), double(y)};
      box.x0 = std::min<double>(box.x0, x), box.x1 = std::max<double>(box.x1, x);
      box.y1 = y;
    }
}

void LabelRenderer::measure_object(std::size_t o) {
  ObjectLabel& object = m_labels.objects[o];
  // Objects are measured beyond the picture too, to tell how much is cut off by its border.
  const PixelRange canvas = label_canvas(m_camera);
  object.whole_box = whole_box(m_views[o], m_camera);
  if (!m_options.visibility || object.whole_box.empty()) return;
  const Silhouette silhouette = draw_silhouette(m_views[o], m_camera, canvas);
  object.num_on_canvas = silhouette.count(canvas);
  object.num_alone = silhouette.count(m_picture);
  object.canvas_box = silhouette.box();
}

Labels LabelRenderer::render() {
  const std::size_t num_pixels = std::size_t(m_camera.width) * m_camera.height;
  m_labels.width = m_camera.width, m_labels.height = m_camera.height;
  m_labels.depth.assign(num_pixels, 0);
  m_labels.instances.assign(num_pixels, kNoInstance);
  if (m_options.normals) m_labels.normals.assign(num_pixels, {});
  m_labels.objects.resize(m_scene.objects.size());
  find_faces();
  // Bands come first: objects are counted in the finished picture.
  const int num_bands = (m_camera.height + kLabelRows - 1) / kLabelRows;
  in_parallel(num_bands, [&](std::size_t band) { draw_band(static_cast<int>(band)); });
  in_parallel(m_views.size(), [&](std::size_t o) { measure_object(o); });
  add_visible(m_labels.objects);
  return std::move(m_labels);
}

}  // namespace

Labels render_labels(const PictureScene& scene, const PinholeCamera& camera,
                     const LabelOptions& options) {
  check_camera(camera);
  check_poses(scene);
  if (scene.objects.size() > kMaxLabelledObjects)
    bad_input("labelled images of %1 objects; accepted: up to %2", scene.objects.size(),
              kMaxLabelledObjects);
  return LabelRenderer(scene, camera, options).render();
}

std::vector<bool> object_silhouette(const PictureScene& scene, std::size_t object,
                                    const PinholeCamera& camera) {
  check_camera(camera);
  const PixelRange picture{0, 0, camera.width - 1, camera.height - 1};
  const Silhouette drawn =
      draw_silhouette(see_object(scene.objects[object], camera), camera, picture);
  std::vector<bool> out(std::size_t(camera.width) * camera.height);
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x)
      out[std::size_t(y) * camera.width + x] = drawn.covers(x, y);
  return out;
}

}  // namespace trivet
