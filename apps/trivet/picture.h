// Pictures of scenes: by OpenGL on graphics hardware, else by rays on the processor.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/image.h"
#include "core/picture/pinhole_camera.h"
#include "core/scene/scene.h"

namespace trivet::apps {

/// OpenGL, where there is any.
class GlPictures {
 public:
  virtual ~GlPictures() = default;
  virtual Image render(const PictureScene& scene, const std::optional<Camera>& camera,
                       const PictureOptions& options) = 0;
  virtual Image render(const PictureScene& scene, const PinholeCamera& camera,
                       const PictureOptions& options) = 0;
  virtual std::string device() const = 0;
};
/// @param device  EGL device, from 1; 0: see usual_device().
/// @throws Error (Environment) without EGL, and in a build without it.
std::unique_ptr<GlPictures> make_gl_pictures(int device);

struct PictureRequest {
  int width = 1280, height = 720;  // pixels
  int samples = 0;                 // per pixel; 0: 32 views of OpenGL, 16 paths
  int bounces = 3;                 // of paths
  std::string renderer = "auto";   // or "opengl", "path"
  int num_threads = 0;             // of paths; 0: all cores
  int device = 0;                  // of OpenGL, see make_gl_pictures()
  std::vector<double> camera;      // eye and target, 6 numbers, metres; empty: frames everything
  double fov_deg = 30;             // for an explicit camera

  int paths_per_pixel() const { return samples > 0 ? samples : 16; }
  /// Empty: chosen automatically.
  std::optional<Camera> explicit_camera() const;
};

/// Created before long work, so that a machine without graphics fails at once where it is needed.
class PictureMaker {
 public:
  /// "auto": OpenGL where the kernel shows graphics hardware and EGL works, else rays.
  /// @throws Error (Environment) for "opengl" without EGL or in a build without it.
  explicit PictureMaker(const PictureRequest& request);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  Image image(const PictureScene& scene, const std::optional<Camera>& camera);
  /// The bytes of a PNG file. @param camera  nullopt: the request's, else one that frames all.
  std::string png(const Scene& scene, const std::optional<Camera>& camera = std::nullopt);
  /// Renderer in use.
  std::string device() const;

 private:
  PictureRequest m_request;
  std::unique_ptr<GlPictures> m_opengl;  // null: rays
};

}  // namespace trivet::apps
