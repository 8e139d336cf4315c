// Paths of light, eight pixels at a time. Private.
#pragma once

#include "core/picture/lights.h"
#include "core/picture/pinhole_camera.h"
#include "raster/path/environment.h"
#include "raster/path/lamps.h"
#include "raster/path/picture.h"
#include "raster/path/sums.h"
#include "raster/path/surface_light.h"

namespace trivet {

class PathTracer {
 public:
  /// The arguments must outlive it.
  PathTracer(const PictureScene& scene, const PinholeCamera& camera, const PictureOptions& options,
             const PathOptions& path);

  /// Means over all samples.
  SumImage trace();

 private:
  struct Path;

  void trace_block(int x0, int y0, SumImage& image) const;
  void start_path(Path& path, int x, int y, int sample) const;
  /// Goes from hit to hit until all paths end.
  void follow(std::array<Path, kRayLanes>& paths) const;
  static void pass_absent(Path& path, const SurfacePoint& at);
  void advance(Path& path, const RayPacket& rays, const HitPacket& hits, int lane) const;
  bool meets_floor(const Path& path, const HitPacket& hits, int lane, float& distance) const;
  SurfacePoint floor_point(const Path& path, float distance) const;
  void leave(Path& path) const;
  void note(Path& path, const SurfacePoint& at, bool on_floor) const;
  void ask_for_light(Path& path, const SurfacePoint& at) const;
  void ask_lamps(Path& path, const SurfacePoint& at, Sampler::Pair u) const;
  void go_on(Path& path, const SurfacePoint& at) const;
  static void finish(const Path& path, PixelSums& sums);
  float floor_coverage(const Vec3f& at) const;
  void set_lens(const PinholeCamera& camera, const PictureLook& look);
  Vec3f sky(const Vec3f& direction, bool mirrored) const;
  Vec3f surroundings(const Vec3f& direction) const;  // of the environment
  void ask_environment(Path& path, const SurfacePoint& at, Sampler::Pair u) const;
  float environment_share() const;

  const PictureOptions& m_options;
  const PathOptions& m_path;
  const PinholeCamera& m_camera;
  const EnvironmentMap* m_environment;
  bool m_has_floor;
  PictureFrame m_frame;
  PathScene m_scene;
  Eigen::Matrix3f m_frame_from_camera;
  Lamps m_lamps;
  Vec3f m_eye, m_sky_horizon, m_sky_slope, m_floor_colour;
  float m_floor_z, m_fade_begin, m_fade_end;
  float m_environment_share;                // of the rays to lights
  float m_lens_radius = 0, m_in_focus = 1;  // distance along the view; picture frame
};

}  // namespace trivet
