// Labelled images against a ray through every pixel and every face.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "raster/labels/labels.h"

namespace trivet {
namespace {

using Real = long double;

struct Mesh3 {
  std::vector<Vec3> vertices;
  std::vector<Index3> triangles;

  PictureMesh view() const {
    PictureMesh mesh;
    mesh.vertices = vertices, mesh.triangles = triangles;
    return mesh;
  }
};

Mesh3 box(const Vec3& half) {
  static constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  Mesh3 mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back(
        half.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  for (const auto& s : kSides) {
    mesh.triangles.push_back({s[0], s[1], s[2]});
    mesh.triangles.push_back({s[0], s[2], s[3]});
  }
  return mesh;
}

using Generator = std::mt19937;

double uniform(Generator& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}
Vec3 random_point(Generator& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

// Triangles that cross each other, share edges, are slivers or have no area.
Mesh3 soup(Generator& random, int count) {
  Mesh3 mesh;
  for (int i = 0; i < count + 2; ++i) mesh.vertices.push_back(random_point(random, 1));
  for (int i = 0; i < count; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  mesh.triangles.push_back({0, 1, 0});
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.vertices.push_back(mesh.vertices[0] + 1e-9 * Vec3::UnitX());
  mesh.triangles.push_back({0, 1, count + 2});
  return mesh;
}

struct TestScene {
  std::vector<Mesh3> meshes;
  std::vector<PictureMesh> views;
  PictureScene scene;
  PinholeCamera camera;
};

void add_object(TestScene& test, std::size_t mesh, double scale, const Vec3& position) {
  PictureObject object;
  object.mesh = &test.views[mesh];
  object.world_from_object.linear *= scale;
  object.world_from_object.translation = position;
  test.scene.objects.push_back(object);
}

PinholeCamera look(const Vec3& eye, const Vec3& target, int width, int height, double fov = 50) {
  Camera camera;
  camera.eye = eye, camera.target = target, camera.fov_deg = fov;
  return pinhole_camera(camera, width, height);
}

// Objects before, behind and around the camera, below a pixel, cut by the edges of the picture.
TestScene random_scene(unsigned seed) {
  Generator random(seed);
  TestScene test;
  test.meshes = {
      box(Vec3(1, 1, 1)), soup(random, 40), soup(random, 12), box(Vec3(1, 0.001, 1)), {}};
  for (const Mesh3& mesh : test.meshes) test.views.push_back(mesh.view());
  const Vec3 eye = Vec3(0, -4, 1.5) + random_point(random, 0.5);
  test.camera = look(eye, random_point(random, 0.5), 67, 43, uniform(random, 30, 120));
  if (seed % 3 == 1) test.camera.cx = 10.25, test.camera.fy *= 1.5;
  for (int i = 0; i < 8; ++i)
    add_object(test, i % 5, uniform(random, 0.1, 0.8), random_point(random, 2));
  add_object(test, 0, 1e-4, Vec3(0, 0, 0.3));         // below a pixel
  add_object(test, 1, 0.5, eye + Vec3(0, -3, 0));     // behind
  if (seed % 4 == 0) add_object(test, 0, 0.05, eye);  // around the camera
  if (seed % 4 == 2) add_object(test, 1, 1.0, eye);   // faces across its plane
  add_object(test, 0, 0.3, Vec3(0.1, 0.2, 0.4));
  add_object(test, 0, 0.3, Vec3(0.1, 0.2, 0.4));  // twice at one place
  test.scene.floor = seed % 3 != 1;
  return test;
}

struct Vec3L {
  Real x, y, z;
};
Vec3L operator-(const Vec3L& a, const Vec3L& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Real dot(const Vec3L& a, const Vec3L& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3L cross(const Vec3L& a, const Vec3L& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Real length(const Vec3L& a) { return std::sqrt(dot(a, a)); }

Vec3L long_vec(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Vec3L in_camera(const Affine& pose, const Vec3& p, const PinholeCamera& camera) {
  Real w[3], out[3];
  for (int r = 0; r < 3; ++r)
    w[r] = Real(pose.linear(r, 0)) * p.x() + Real(pose.linear(r, 1)) * p.y() +
           Real(pose.linear(r, 2)) * p.z() + pose.translation[r] - Real(camera.eye[r]);
  for (int r = 0; r < 3; ++r)
    out[r] = camera.camera_from_world(r, 0) * w[0] + camera.camera_from_world(r, 1) * w[1] +
             camera.camera_from_world(r, 2) * w[2];
  return {out[0], out[1], out[2]};
}

Vec3L ray_of(const PinholeCamera& camera, Real x, Real y) {
  return {(x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, 1};
}

struct FaceHit {
  Real depth = 0;         // 0: none
  bool doubtful = false;  // within rounding of an edge, or edge-on
};

// Moeller and Trumbore's, in more digits; within 1e-11 of an edge a hit is doubtful.
FaceHit hit_face(const Vec3L (&t)[3], const Vec3L& ray) {
  const Vec3L e1 = t[1] - t[0], e2 = t[2] - t[0];
  const Vec3L h = cross(ray, e2);
  const Real det = dot(e1, h);
  const Real size = length(e1) * length(e2) * length(ray);
  FaceHit out;
  if (std::abs(det) <= 1e-11L * size) {
    out.doubtful = size > 0;  // edge-on or a sliver: only its outline may be met
    if (det == 0) return out;
  }
  const Vec3L s = Vec3L{0, 0, 0} - t[0];
  const Vec3L q = cross(s, e1);
  const Real u = dot(s, h) / det, v = dot(ray, q) / det, depth = dot(e2, q) / det;
  const Real margin = 1e-13L * (1 + size / std::abs(det)) * (1 + length(t[0]) / length(e1)) *
                      (1 + length(t[0]) / length(e2));
  const Real inside = std::min({u, v, 1 - u - v});
  if (inside < -margin || depth <= 0) return {0, out.doubtful && inside >= -1e3L * margin};
  out.doubtful |= inside < margin;
  out.depth = depth;
  return out;
}

struct BruteForce {
  std::vector<std::array<Vec3L, 3>> faces;
  std::vector<int> object;

  explicit BruteForce(const TestScene& test) {
    for (std::size_t o = 0; o < test.scene.objects.size(); ++o) {
      const PictureObject& it = test.scene.objects[o];
      for (const Index3& t : it.mesh->triangles) {
        std::array<Vec3L, 3> face;
        for (int c = 0; c < 3; ++c)
          face[c] = in_camera(it.world_from_object, it.mesh->vertices[t[c]], test.camera);
        faces.push_back(face);
        object.push_back(static_cast<int>(o));
      }
    }
  }
};

bool within_one_ulp(float value, Real exact) {
  const float nearest = static_cast<float>(exact);
  return value >= std::nextafter(nearest, -1.0f) && value <= std::nextafter(nearest, 3e38f);
}

struct PixelTruth {
  Real depth = 0;  // 0: nothing
  int instance = kNoInstance;
  bool doubtful = false;  // rounding decides; any answer is right
  std::vector<int> tied;  // instances as near, within rounding
};

PixelTruth truth_of(const TestScene& test, const BruteForce& all, int x, int y) {
  const Vec3L ray = ray_of(test.camera, x, y);
  PixelTruth out;
  std::vector<std::pair<Real, int>> hits;
  Real doubtful_from = 1e30L;
  for (std::size_t f = 0; f < all.faces.size(); ++f) {
    const auto& t = all.faces[f];
    const FaceHit hit = hit_face({t[0], t[1], t[2]}, ray);
    if (hit.doubtful)
      doubtful_from = std::min({doubtful_from, t[0].z, t[1].z, t[2].z});
    else if (hit.depth > 0)
      hits.emplace_back(hit.depth, all.object[f] + 1);
  }
  const Vec3L up = long_vec(test.camera.camera_from_world.col(2));
  const Real fall = -dot(up, ray);
  if (test.scene.floor && test.camera.eye.z() > 0 && fall > 0)
    hits.emplace_back(test.camera.eye.z() / fall, kFloorInstance);
  if (!hits.empty()) {
    std::tie(out.depth, out.instance) = *std::min_element(hits.begin(), hits.end());
    for (const auto& [depth, instance] : hits)
      if (depth <= out.depth * (1 + 1e-12L)) out.tied.push_back(instance);
  }
  out.doubtful =
      doubtful_from < 1e30L && (hits.empty() || doubtful_from <= out.depth * (1 + 1e-9L));
  return out;
}

TEST(Labels, AgreeWithARayThroughEveryPixelAndFace) {
  int num_pixels = 0, num_doubtful = 0, num_objects_seen = 0, num_floor = 0, num_tied = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TestScene test = random_scene(seed);
    const Labels labels = render_labels(test.scene, test.camera);
    const BruteForce all(test);
    for (int y = 0; y < labels.height; ++y)
      for (int x = 0; x < labels.width; ++x) {
        const std::size_t i = std::size_t(y) * labels.width + x;
        const PixelTruth truth = truth_of(test, all, x, y);
        ++num_pixels;
        num_doubtful += truth.doubtful;
        if (truth.doubtful) continue;
        ASSERT_TRUE(within_one_ulp(labels.depth[i], truth.depth))
            << x << ", " << y << ": " << labels.depth[i] << " for " << double(truth.depth);
        if (truth.tied.size() > 1 &&
            std::count(truth.tied.begin(), truth.tied.end(), labels.instances[i]) > 0) {
          ++num_tied;
          continue;
        }
        ASSERT_EQ(labels.instances[i], truth.instance) << x << ", " << y;
        num_floor += truth.instance == kFloorInstance;
        num_objects_seen += truth.instance != kFloorInstance && truth.instance != kNoInstance;
      }
  }
  EXPECT_LT(num_doubtful, num_pixels / 200);
  EXPECT_GT(num_objects_seen, num_pixels / 5);
  EXPECT_GT(num_floor, num_pixels / 20);
  EXPECT_GT(num_tied, 0);
}

// The same object without the others, seen by the same camera or by one that sees the canvas.
Labels alone(const TestScene& test, std::size_t object, bool canvas) {
  PictureScene scene{{test.scene.objects[object]}, false};
  PinholeCamera camera = test.camera;
  if (canvas) {
    camera.cx += camera.width, camera.cy += camera.height;
    camera.width *= 3, camera.height *= 3;
  }
  return render_labels(scene, camera);
}

std::int64_t count_of(const Labels& labels, int instance) {
  return std::count(labels.instances.begin(), labels.instances.end(), instance);
}

TEST(Labels, CountVisibleAndHiddenPixels) {
  int num_hidden = 0, num_cut = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TestScene test = random_scene(seed);
    const Labels labels = render_labels(test.scene, test.camera);
    for (std::size_t o = 0; o < labels.objects.size(); ++o) {
      const ObjectLabel& object = labels.objects[o];
      const Labels only = alone(test, o, false);
      EXPECT_EQ(object.num_visible, count_of(labels, int(o) + 1));
      EXPECT_EQ(object.num_alone, count_of(only, 1));
      // Adding the width to the principal point moves rounding by a pixel here and there.
      EXPECT_NEAR(double(object.num_on_canvas), double(count_of(alone(test, o, true), 1)), 2);
      EXPECT_LE(object.num_visible, object.num_alone);
      EXPECT_LE(object.num_alone, object.num_on_canvas);
      const std::vector<bool> silhouette = object_silhouette(test.scene, o, test.camera);
      for (std::size_t i = 0; i < silhouette.size(); ++i)
        ASSERT_EQ(silhouette[i], only.instances[i] == 1) << i;
      num_hidden += object.num_visible < object.num_alone;
      num_cut += object.num_alone < object.num_on_canvas;
    }
  }
  EXPECT_GT(num_hidden, 20);
  EXPECT_GT(num_cut, 20);
}

TEST(Labels, BoxesHoldPixelsAndVertices) {
  int num_whole = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TestScene test = random_scene(seed);
    const Labels labels = render_labels(test.scene, test.camera);
    const BruteForce all(test);
    for (std::size_t o = 0; o < labels.objects.size(); ++o) {
      LabelBox visible;
      for (int y = 0; y < labels.height; ++y)
        for (int x = 0; x < labels.width; ++x)
          if (labels.instances[std::size_t(y) * labels.width + x] == o + 1) {
            if (visible.empty()) visible = {double(x), double(y), double(x), double(y)};
            visible = {std::min<double>(visible.x0, x), visible.y0, std::max<double>(visible.x1, x),
                       double(y)};
          }
      const ObjectLabel& object = labels.objects[o];
      EXPECT_EQ(object.visible_box.empty(), visible.empty());
      if (!visible.empty()) {
        EXPECT_EQ(object.visible_box.x0, visible.x0);
        EXPECT_EQ(object.visible_box.y0, visible.y0);
        EXPECT_EQ(object.visible_box.x1, visible.x1);
        EXPECT_EQ(object.visible_box.y1, visible.y1);
      }
      Real x0 = 1e30L, y0 = 1e30L, x1 = -1e30L, y1 = -1e30L;
      int num_front = 0, num_behind = 0;
      for (std::size_t f = 0; f < all.faces.size(); ++f)
        if (all.object[f] == int(o))
          for (const Vec3L& p : all.faces[f]) {
            ++(p.z > 0 ? num_front : num_behind);
            const Real x = test.camera.fx * p.x / p.z + test.camera.cx;
            const Real y = test.camera.fy * p.y / p.z + test.camera.cy;
            x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
          }
      EXPECT_EQ(object.whole_box.empty(), num_front == 0);
      if (num_front == 0 || num_behind > 0) continue;
      ++num_whole;
      const Real w = labels.width, h = labels.height;
      EXPECT_NEAR(object.whole_box.x0, double(std::clamp(x0, -w - 0.5L, 2 * w - 0.5L)), 1e-9);
      EXPECT_NEAR(object.whole_box.y0, double(std::clamp(y0, -h - 0.5L, 2 * h - 0.5L)), 1e-9);
      EXPECT_NEAR(object.whole_box.x1, double(std::clamp(x1, -w - 0.5L, 2 * w - 0.5L)), 1e-9);
      EXPECT_NEAR(object.whole_box.y1, double(std::clamp(y1, -h - 0.5L, 2 * h - 0.5L)), 1e-9);
    }
  }
  EXPECT_GT(num_whole, 100);
}

TEST(Labels, NormalsFaceTheCamera) {
  TestScene test;
  test.meshes = {box(Vec3(1, 1, 1))};
  test.views = {test.meshes[0].view()};
  add_object(test, 0, 1, Vec3(0, 0, 1));
  test.camera = look(Vec3(0, -5, 1), Vec3(0, 0, 1), 31, 31);
  const Labels labels = render_labels(test.scene, test.camera);
  const std::array<float, 3>& middle = labels.normals[15 * 31 + 15];
  EXPECT_FLOAT_EQ(labels.depth[15 * 31 + 15], 4);
  EXPECT_FLOAT_EQ(middle[2], -1);
  EXPECT_EQ(labels.instances[30 * 31 + 15], kFloorInstance);
  EXPECT_FLOAT_EQ(labels.normals[30 * 31 + 15][1], -1);  // up is against y
}

TEST(Labels, AnEmptySceneIsEmptyOrFloor) {
  PictureScene scene;
  scene.floor = false;
  const PinholeCamera camera = look(Vec3(0, -3, 1), Vec3::Zero(), 16, 8);
  EXPECT_EQ(count_of(render_labels(scene, camera), kNoInstance), 16 * 8);
  scene.floor = true;
  EXPECT_GT(count_of(render_labels(scene, camera), kFloorInstance), 60);
  const PinholeCamera below = look(Vec3(0, -3, -1), Vec3::Zero(), 16, 8);
  EXPECT_EQ(count_of(render_labels(scene, below), kFloorInstance), 0);
}

TEST(Labels, AreTheSameFarFromTheOrigin) {
  TestScene test = random_scene(7);
  const Labels near = render_labels(test.scene, test.camera);
  const Vec3 far(68719476736, -68719476736, 0);
  // Rounds the near poses as the far ones are.
  for (PictureObject& object : test.scene.objects)
    object.world_from_object.translation = (object.world_from_object.translation + far) - far;
  test.camera.eye = (test.camera.eye + far) - far;
  const Labels rounded = render_labels(test.scene, test.camera);
  for (PictureObject& object : test.scene.objects) object.world_from_object.translation += far;
  test.camera.eye += far;
  const Labels there = render_labels(test.scene, test.camera);
  EXPECT_EQ(there.depth, rounded.depth);
  EXPECT_EQ(there.instances, rounded.instances);
  EXPECT_NE(near.depth, rounded.depth);
}

TEST(Labels, AreTheSameForAnyNumberOfThreads) {
  const TestScene test = random_scene(2);
  const auto with = [&](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Labels labels;
    tbb::task_arena(threads).execute([&] { labels = render_labels(test.scene, test.camera); });
    return labels;
  };
  const Labels one = with(1);
  for (const int threads : {2, 3, 8}) {
    const Labels many = with(threads);
    EXPECT_EQ(one.depth, many.depth);
    EXPECT_EQ(one.instances, many.instances);
    EXPECT_EQ(one.normals, many.normals);
  }
}

TEST(Labels, RefuseBadCameras) {
  const TestScene test = random_scene(1);
  const auto expect_refused = [&](const PinholeCamera& camera, const std::string& named) {
    try {
      render_labels(test.scene, camera);
      ADD_FAILURE() << "accepted " << named;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::BadInput);
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
  };
  PinholeCamera camera = test.camera;
  camera.width = 0;
  expect_refused(camera, "0 x 43");
  camera = test.camera;
  camera.fy = -1;
  expect_refused(camera, "focal");
  camera = test.camera;
  camera.cx = kInfinity;
  expect_refused(camera, "principal");
  camera = test.camera;
  camera.eye.x() = std::nan("");
  expect_refused(camera, "finite");
  camera = test.camera;
  camera.camera_from_world *= 2;
  expect_refused(camera, "rotation");
  camera.camera_from_world = -test.camera.camera_from_world;
  expect_refused(camera, "rotation");
}

TEST(PinholeCamera, ProjectsAsThePictureDoes) {
  Camera camera;
  camera.eye = Vec3(1, -2, 1.5), camera.target = Vec3(0.1, 0.2, 0.3), camera.fov_deg = 37;
  const PinholeCamera pinhole = pinhole_camera(camera, 640, 480);
  check_camera(pinhole);
  const Vec3 target = pinhole.apply(camera.target);
  EXPECT_NEAR(target.x(), 0, 1e-12);
  EXPECT_NEAR(target.y(), 0, 1e-12);
  EXPECT_GT(target.z(), 0);
  EXPECT_LT(pinhole.apply(camera.target + 0.1 * Vec3::UnitZ()).y(), 0);  // y is down
  EXPECT_NEAR(pinhole.fy, 240 / std::tan(37 * 3.14159265358979323846 / 360), 1e-9);
}

}  // namespace
}  // namespace trivet
