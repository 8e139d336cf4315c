// Private to gpu: draws live views and caches data between pictures.
//
// Draws backdrop, opaque objects, floor, see-through parts, ghosts and overlays into a multisampled
// target; then outlines, found in a mask.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/image.h"
#include "gpu/egl/gl_objects.h"
#include "gpu/live/camera.h"
#include "gpu/live/overlay.h"
#include "gpu/live/view.h"
#include "gpu/picture/mesh.h"

namespace trivet {

/// Program that draws meshes, with the locations of its per-mesh uniforms.
struct MeshProgram {
  MeshProgram(const char* name, const std::string& vertex, const std::string& fragment);
  GlProgram program;
  GLint frame_from_object, frame_from_normal, tint, opacity;
  FinishUniforms finish;
};

struct LivePrograms {
  LivePrograms();
  MeshProgram object, textured_object, shadow, textured_shadow, mask;
  GlProgram floor, backdrop, outline, overlay;
};

inline constexpr int kLiveShadowMapPx = 2048;   // side
inline constexpr int kDraftShadowMapPx = 1024;  // part of it used by drafts
extern const Vec3 kLiveLight;                   // towards it, unit, world

void bind_target(const GlFramebuffer& framebuffer, int width, int height);
void copy_target(const GlFramebuffer& from, const GlFramebuffer& to, int width, int height,
                 GLbitfield what);
/// State for solid geometry: both sides, nearest first.
void prepare_to_draw_solids();
/// State for blended geometry; the picture itself stays opaque.
void blend_over();
Eigen::Matrix4d world_from_frame(const PictureFrame& frame);

/// Render targets of one view.
struct LiveTargets {
  LiveTargets(int width, int height, int samples);
  int width, height;
  GlRenderbuffer colour, depth;
  GlTexture picture, mask;
  GlFramebuffer draw, draw_picture, draw_mask;
};

/// Cached picture of the static objects.
struct LiveStill {
  LiveStill(int width, int height);
  int width, height;
  GlRenderbuffer colour, depth;
  GlFramebuffer draw;
  std::string key;  // identifies its content
  double near_depth = 0, far_depth = 0;
};

class LiveRenderer {
 public:
  /// @param many_triangles  in larger scenes, drafts redraw only the moving objects.
  explicit LiveRenderer(std::int64_t many_triangles);

  Image draw(const LiveScene& scene, const LiveCamera& camera, const LiveOptions& options);
  const LiveView::Work& work() const { return m_work; }

 private:
  struct Kept {  // cached per view
    std::optional<LiveTargets> full, draft;
    std::optional<LiveStill> still;
  };
  struct KnownMesh {
    std::weak_ptr<const Model> model;
    UploadedMesh mesh;
  };
  struct Instance {
    const LiveObject* object = nullptr;
    const UploadedMesh* mesh = nullptr;
    std::array<Vec3, 8> corners;  // of its box, world
    MeshPlacement placement;
    double depth = 0;  // of its middle
    bool seen = true;
    LiveColour tint = {};  // linear
  };
  struct View {  // the picture being drawn
    const LiveScene& scene;
    const LiveCamera& camera;
    const LiveOptions& options;
    ViewAxes axes;
    Vec3 floor_centre = Vec3::Zero();
    double floor_radius = 1;  // world
    double near_depth = 0, far_depth = 1;
    Eigen::Matrix4d clip_from_world = {};

    /// Distance from the camera to its target, or the height it shows.
    double reach() const {
      return camera.height ? *camera.height : (camera.eye - camera.target).norm();
    }
  };
  /// Which groups of meshes are drawn: the solid ones are opaque or cut out.
  enum class Part { Solid, SeeThrough, All };

  const UploadedMesh& mesh_of(const std::shared_ptr<const Model>& model);
  void place_instances(const LiveScene& scene);
  void find_depth_range(View& view) const;
  void cull(const View& view);
  void coarsen(const View& view);
  void draw_as_box(Instance& instance);
  void draw_shadow_map(const View& view, bool of_moving);
  void draw_all(View& view, const LiveTargets& targets);
  static std::string key_of_still(const View& view);
  static void begin_still(const View& view, std::string key, std::optional<LiveStill>& still);
  void draw_still(const View& view, const LiveStill& still);
  void draw_draft(View& view, Kept& kept);
  void draw_backdrop(const View& view);
  void draw_floor(const View& view);
  void prepare_objects(const View& view, const MeshProgram& program) const;
  /// With the program in use; of textured meshes only if it is for them.
  void draw_one(const MeshProgram& program, const Instance& instance, Part part) const;
  void draw_object(const View& view, const Instance& instance, Part part);
  void draw_solid(const View& view, bool still, bool moving);
  void draw_translucent(const View& view);
  void draw_overlay(const View& view);
  void draw_outlines(const View& view, const LiveTargets& targets);
  void set_shadow_uniforms(const GlProgram& program, const View& view) const;
  Image read(const LiveTargets& targets) const;

  std::int64_t m_many_triangles;
  LivePrograms m_programs;
  UploadedMesh m_box;  // from -1 to 1 each way
  GlVertexArray m_no_attributes, m_overlay_array;
  GlBuffer m_overlay_buffer;
  GlTexture m_shadow_map;
  GlFramebuffer m_draw_shadow_map;
  std::optional<std::string> m_shadow_key;  // of its current content
  Eigen::Matrix4d m_map_from_world = Eigen::Matrix4d::Identity();
  double m_shadow_texel = 0;  // world
  int m_shadow_px = kLiveShadowMapPx;
  std::map<const Model*, KnownMesh> m_meshes;
  std::map<int, Kept> m_views;
  PictureFrame m_frame;
  std::vector<Instance> m_instances;
  std::int64_t m_num_triangles = 0;
  const MeshProgram* m_prepared = nullptr;  // whose uniforms of the view are set
  LiveView::Work m_work;
};

}  // namespace trivet
