// Small live views of scenes with a known appearance.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "core/base/error.h"
#include "core/picture/png.h"
#include "gpu/live/camera.h"
#include "gpu/live/view.h"

namespace trivet::test {

inline constexpr int kWidth = 240, kHeight = 180;

inline std::shared_ptr<const Model> box_model(const Vec3& lower, const Vec3& upper,
                                              const std::array<float, 4>& colour) {
  static constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  auto model = std::make_shared<Model>();
  for (int i = 0; i < 8; ++i)
    model->mesh.vertices.push_back({i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                                    i & 4 ? upper.z() : lower.z()});
  for (const auto& s : kSides) {
    model->mesh.triangles.push_back({s[0], s[1], s[2]});
    model->mesh.triangles.push_back({s[0], s[2], s[3]});
  }
  Material material;
  material.base_colour = colour;
  model->materials = {material};
  return model;
}

inline const std::array<float, 4> kGrey{0.5f, 0.5f, 0.5f, 1};

inline LiveObject placed(std::shared_ptr<const Model> model, const Vec3& at = Vec3::Zero()) {
  LiveObject object;
  object.model = std::move(model);
  object.world_from_object.translation = at;
  return object;
}

inline LiveScene cube_scene() {
  LiveScene scene;
  scene.objects = {placed(box_model(Vec3(-1, -1, 0), Vec3(1, 1, 2), kGrey))};
  return scene;
}

/// Looks straight down on the origin, 9 m high and 12 m wide; 20 pixels a metre; +x right, +y up.
inline LiveCamera from_above() {
  LiveCamera camera;
  camera.eye = Vec3(0, 0, 10);
  camera.target = Vec3::Zero();
  camera.up = Vec3::UnitY();
  camera.height = 9;
  return camera;
}

inline LiveOptions small() {
  LiveOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.theme = LiveTheme::light();
  options.theme.grid[3] = options.theme.axis_x[3] = options.theme.axis_y[3] = 0;
  return options;
}

inline double brightness(const Image& image, const Vec2& at) {
  const std::uint8_t* p = image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
  return (p[0] + p[1] + p[2]) / 3.0;
}

inline Vec2 pixel(const LiveCamera& camera, const Vec3& world, double width = kWidth,
                  double height = kHeight) {
  const ViewAxes axes = make_view_axes(camera, width / height);
  const Eigen::Vector4d p = clip_from_world(camera, axes, 0.1, 100) * world.homogeneous();
  return {0.5 * (p.x() / p.w() + 1) * width, 0.5 * (1 - p.y() / p.w()) * height};
}

inline int num_different(const Image& a, const Image& b, int by = 24) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4)
    count += std::abs(a.rgba[i] - b.rgba[i]) > by || std::abs(a.rgba[i + 1] - b.rgba[i + 1]) > by ||
             std::abs(a.rgba[i + 2] - b.rgba[i + 2]) > by;
  return count;
}

/// True if a pixel within 1 of there has that colour.
inline bool has_colour(const Image& image, const Vec2& at, const LiveColour& colour,
                       int tolerance = 40) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int x = static_cast<int>(at.x()) + dx, y = static_cast<int>(at.y()) + dy;
      if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
      const std::uint8_t* p = image.pixel(x, y);
      bool same = true;
      for (int c = 0; c < 3; ++c) same = same && std::abs(p[c] - 255 * colour[c]) <= tolerance;
      if (same) return true;
    }
  return false;
}

class Live : public testing::Test {
 protected:
  void SetUp() override {
    try {
      m_context = std::make_unique<EglContext>();
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
    m_view = std::make_unique<LiveView>(*m_context);
  }
  Image draw(const LiveScene& scene, const LiveCamera& camera,
             const LiveOptions& options = small()) {
    return m_view->draw(scene, camera, options);
  }
  /// Saves pictures for inspection if TRIVET_PICTURES names a folder.
  static void keep(const Image& image, const std::string& name) {
    if (const char* folder = std::getenv("TRIVET_PICTURES"))
      write_png(image, std::string(folder) + "/" + name + ".png");
  }

  std::unique_ptr<EglContext> m_context;
  std::unique_ptr<LiveView> m_view;
};

}  // namespace trivet::test
