// Private to gpu: renders one picture, tile by tile.
//
// Accumulates many cheap views instead of a few complex ones: each sub-pixel view is shaded by six
// directional lights with hard shadows, and the sum over the views is anti-aliased, softly shadowed
// and ambiently occluded, without the artefacts of screen-space methods.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/picture/frame.h"
#include "core/picture/lights.h"
#include "gpu/egl/gl_objects.h"
#include "gpu/picture/geometry.h"
#include "gpu/picture/shadow_map.h"
#include "gpu/picture/store.h"

namespace trivet {

/// Textures of one tile, shadow maps, the floor's light, and their framebuffers.
struct PictureTargets {
  /// @param emits  whether surfaces give light, which takes a target more.
  PictureTargets(int width, int height, int map_size, bool emits);
  GlTexture surfaces, emission, depth, sums, developed, floor_light, maps;
  GlFramebuffer draw_surfaces, draw_sums, draw_developed, draw_floor_light;
  std::array<GlFramebuffer, kLightsPerView> draw_maps;
};

/// State for both sides of every triangle, nearest first.
void prepare_to_draw();
/// State for additive blending.
void add_to_target();

inline constexpr int kFloorLightPx = 128;                  // side
inline constexpr double kFadeBegin = 1.0, kFadeEnd = 3.2;  // of the floor, in radii of the scene

/// A rectangle of pixels, counted from the lower left of the picture.
struct PictureTile {
  int x = 0, y = 0, width = 0, height = 0;
};

class PictureRenderer {
 public:
  /// `options` and `store` must outlive it. Needs a current context throughout its lifetime.
  PictureRenderer(const PictureScene& scene, const FrameCamera& camera,
                  const PictureOptions& options, PictureStore& store);

  Image render();

 private:
  using Lights = std::array<PictureLight, kLightsPerView>;

  bool casts_shadows(int light) const {
    return light == 0 ? m_options.shadows : m_options.ambient_occlusion;
  }
  double floor_radius() const { return std::max(m_frame.radius, 0.05); }  // minimum for thin posts
  void set_map_sizes(int key_px, int other_px);
  void find_depth_range();
  std::vector<PictureTile> tiles() const;
  void render_view(int view, const PictureTile& tile);
  void measure_floor_light();
  void draw_shadow_maps(int view, const Lights& lights);
  void draw_surfaces(int view, const PictureTile& tile);
  /// Values that all programs of geometry take for one view or light.
  struct GeometryView {
    const Eigen::Matrix4f& clip_from_frame;
    int view;
    PictureTile tile;
  };
  void draw_with(const GlProgram& program, const PictureGeometry::Which& which,
                 const GeometryView& view) const;
  void add_light(int view, const PictureTile& tile, const Lights& lights);
  void set_view_uniforms(int view, const PictureTile& tile);
  void set_light_uniforms(const GlProgram& program, const Lights& lights);
  void develop(const PictureTile& tile, Image& image);
  Eigen::Matrix4f clip_from_frame(const PictureTile& tile, const Vec2& jitter_px) const;

  const PictureOptions& m_options;
  bool m_has_floor;
  PictureFrame m_frame;
  FrameCamera m_camera;
  PictureLights m_lights;
  std::array<int, kLightsPerView> m_map_px{};
  double m_near = 0.01, m_far = 10;
  PictureGeometry m_geometry;
  const PicturePrograms& m_programs;
  const TexturedPrograms* m_textured;  // null: there are none
  PictureTargets m_targets;
  GlVertexArray m_no_attributes;  // the core profile requires a vertex array to draw
  std::array<ShadowMap, kLightsPerView> m_maps;
};

}  // namespace trivet
