// Content of a picture and its camera, shared by all renderers.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/io/textures/surface_look.h"

namespace trivet {

/// View of triangles and their appearance; the referenced arrays must outlive the rendering.
/// Triangles with non-finite coordinates are left out.
struct PictureMesh {
  std::span<const Vec3> vertices;     // #V, object frame
  std::span<const Index3> triangles;  // #F, vertex ids; both sides are drawn
  // #F x 3, object frame; empty: computed from the faces, creased at sharp angles.
  std::span<const std::array<Eigen::Vector3f, 3>> corner_normals;
  std::span<const Index> face_material;  // #F; empty: the first material
  std::span<const Material> materials;   // linear RGB, alpha < 1 is see-through; empty: light grey
  // Textures, vertex colours and more, with materials and faces of their own, made when a renderer
  // first asks, with at most so many bytes of texels; empty, or null: the members above are all.
  std::function<std::shared_ptr<const SurfaceLook>(std::size_t max_bytes)> look;
  // Owner of the arrays: while it lives, renderers may keep what they made of this mesh. Empty:
  // nothing is kept.
  std::weak_ptr<const void> source;
};

/// Mesh of the whole model, which must outlive it. A model without any colour gets a quiet one of
/// its own (quiet_colour.h). Textures are decoded when first drawn, once for all copies of the
/// mesh.
PictureMesh picture_mesh(const Model& model);
/// The same, with the model as its source.
PictureMesh picture_mesh(const std::shared_ptr<const Model>& model);

struct PictureObject {
  const PictureMesh* mesh = nullptr;  // objects may share one
  Affine world_from_object;
  std::optional<std::array<float, 4>> highlight;  // linear RGB and its strength, 0 to 1
};

struct PictureScene {
  std::vector<PictureObject> objects;
  bool floor = true;  // at z = 0
};

/// Camera at `eye`, looking at `target`; world frame, metres.
struct Camera {
  Vec3 eye = Vec3(1, -2, 1);
  Vec3 target = Vec3::Zero();
  Vec3 up = Vec3::UnitZ();  // replaced by another direction if parallel to the view
  double fov_deg = 30;      // from the lower to the upper edge, 1 to 170
};

inline constexpr int kMaxPictureSide = 16384;  // pixels

struct PictureOptions {
  int width = 1280, height = 720;  // pixels, 1 to 16384
  // Sub-pixel views to average, 1 to 4096. Each adds one light of the key light's disc, three of
  // the sky and two from the floor, each with a shadow map. Time grows with it, noise and steps in
  // soft shadows shrink: 8 is a draft, 32 clean, 128 for print.
  int samples = 32;
  bool shadows = true;                                         // of the key light
  bool ambient_occlusion = true;                               // shadows from sky and floor light
  std::array<float, 4> background{0.92f, 0.93f, 0.95f, 1.0f};  // sRGB and alpha, 0 to 1
  std::function<void(double)> progress;                        // called with the completed fraction
};

/// A three-quarter view from above that frames all objects tightly, with every vertex in the
/// picture; an empty scene is framed like a cube of 1 m.
/// @param aspect  width / height.
Camera automatic_camera(const PictureScene& scene, double aspect);

/// @throws Error (BadInput) naming the object whose pose is not finite.
void check_poses(const PictureScene& scene);
/// @throws Error (BadInput) for sizes, samples, colours or poses out of range.
void check_picture(const PictureScene& scene, const PictureOptions& options);

}  // namespace trivet
