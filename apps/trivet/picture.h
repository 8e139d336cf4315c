// Pictures of scenes, in builds with and without EGL.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "gpu/egl/image.h"

namespace trivet::apps {

struct PictureRequest {
  int width = 1280, height = 720;  // pixels
  int samples = 32;
  std::vector<double> camera;  // eye and target, 6 numbers, metres; empty: frames everything
  double fov_deg = 30;         // for an explicit camera
};

/// Created before long work, so that a machine without graphics fails at once.
class PictureMaker {
 public:
  /// @throws Error (Environment) without EGL, or in a build without pictures.
  explicit PictureMaker(const PictureRequest& request);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// The bytes of a PNG file.
  std::string png(const Scene& scene);
  /// Renderer in use.
  std::string device() const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

/// Encodes a PNG file. @throws Error (Environment) in a build without pictures, even for an empty
/// image, so that callers can check before the work.
std::string png_of(const Image& image);

}  // namespace trivet::apps
