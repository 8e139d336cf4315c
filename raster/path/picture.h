// Pictures by rays on the processor: soft shadows, reflections, glass, light between surfaces.
#pragma once

#include <array>
#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/image.h"
#include "core/picture/pinhole_camera.h"

namespace trivet {

/// Thrown when PathOptions::cancel was set.
class PictureCancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "the picture was cancelled"; }
};

class EnvironmentMap;

/// A lamp that is not seen itself, but for its mirror images on rough surfaces.
struct PictureLamp {
  enum class Kind {
    Sun,   // far away: a disc of parallel light
    Bulb,  // a ball that shines in all directions
    Panel  // a square that faces the middle of the scene; nothing behind it is lit
  };
  Kind kind = Kind::Sun;
  Vec3 towards = Vec3::UnitZ();  // from the middle of the scene's box, world; of any length
  double distance = 1;           // metres, from there; of a sun none
  double size = 0.1;             // metres: diameter or side; of a sun its angle in radians
  /// In the middle of the scene on a surface that faces it: times the studio's key light.
  Vec3 colour = Vec3::Ones();
};

/// Light, floor and camera of a picture, relative to those of the studio.
struct PictureLook {
  std::vector<PictureLamp> lamps;  // instead of the key light; none, and no environment: that one
  bool key_beside = false;         // the key light shines beside lamps or an environment, too
  std::optional<Vec3> key;  // towards the key light, world; none: behind the viewer, to the left
  Vec3 key_colour = Vec3::Ones(), sky_colour = Vec3::Ones();   // times the studio's, linear RGB
  Vec3 floor_colour = Vec3::Constant(0.62);                    // linear RGB
  std::array<float, 4> background{0.92f, 0.93f, 0.95f, 1.0f};  // sRGB and alpha
  // Light and background instead of key light and sky, beside the lamps; radiance is times
  // environment_strength.
  std::shared_ptr<const EnvironmentMap> environment;
  double environment_strength = 1;
  Vec2 environment_turn = {1, 0};  // cosine and sine of its turn about z
  double exposure = 1;             // times all light
  // A lens instead of a pinhole: of a sensor 36 mm wide, so that its focal length follows from the
  // camera. 0: all is sharp. Labels are those of the pinhole.
  double f_number = 0;
  double focus = 1;  // times the distance to the middle of the scene
  double noise = 0;  // standard deviation of each component, of 1
  std::uint64_t noise_seed = 0;
};

struct PathOptions {
  /// Reflections that a path may have before it ends in an estimate; 0 to 64. 0: shadows and sky
  /// only, as OpenGL's pictures have. See-through surfaces do not count.
  int bounces = 3;
  /// Smooth what is left of the noise, guided by normals, positions and colours: worth about three
  /// times the samples at 4 to 16.
  bool filter = true;
  PictureLook look;
  /// Set from another thread or by a signal: trace_picture() throws PictureCancelled, within the
  /// time of eight pixels once the tree of all triangles is made.
  const std::atomic<bool>* cancel = nullptr;
};

/// Renders the scene as render_picture() of gpu does: same cameras, same key light, sky, floor and
/// film; `samples` are paths per pixel: 4 with the filter is a draft, 16 clean, 64 for print.
/// See-through materials of closed meshes are glass, of index 1.5, that absorbs by thickness; of
/// open meshes, thin sheets. Path tracing by Embree with light sampling; even random numbers per
/// pixel, sums in a fixed order: the same bytes for any number of threads of the arena, on one
/// machine (the mathematical library is used, as pictures are no answers). `progress` is called
/// from any thread, one at a time; what it throws ends the work.
/// @throws Error (BadInput) for sizes, samples, bounces, camera or poses out of range;
///   (Environment) for lack of memory.
Image trace_picture(const PictureScene& scene, const PinholeCamera& camera,
                    const PictureOptions& options = {}, const PathOptions& path = {});
/// The same as a picture of the camera's size: the bytes of a PNG file.
std::string traced_png(const PictureScene& scene, const PinholeCamera& camera, int samples,
                       const PathOptions& path = {});
/// Without a camera, with the automatic one.
Image trace_picture(const PictureScene& scene, const std::optional<Camera>& camera,
                    const PictureOptions& options = {}, const PathOptions& path = {});

}  // namespace trivet
