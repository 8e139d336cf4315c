#include "raster/path/tracer.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "raster/path/state.h"

namespace trivet {
namespace {

constexpr float kRayEnd = 1e6f;                     // of the picture frame
constexpr float kDimGround = 0.30f;                 // radiance from below without a floor
constexpr float kFromNeighbours = 0.45f;            // share of the sky's light where paths end
constexpr float kBelowTolerance = 2e-4f;            // objects up to this below the floor hide it
constexpr double kFadeBegin = 1.0, kFadeEnd = 3.2;  // of the floor, in radii of the scene
constexpr int kSkyViews = 256;                      // that the lights' brightness is fitted to
constexpr float kLeastLightShare = 0.1f;            // of rays to lights: environment, lamps
constexpr float kKeep = 1.5f;                       // paths of this inverse weight go on
constexpr int kMaxThrough = 24;                     // see-through surfaces of a path
constexpr int kMaxAbsent = 256;                     // cut-out ones
constexpr double kSensorWidth = 0.036;              // metres, of a camera with a lens
// Cones of rays, over which textures are looked up; by length. Half a pixel, as samples differ.
constexpr float kPixelShare = 0.5f, kMattSpread = 0.3f, kBrightSpread = 0.2f;

float smoothstep(float a, float b, float x) {
  const float t = std::clamp((x - a) / (b - a), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

float opacity_of(const SurfacePoint& at) {
  return at.material.finish == Finish::Thin ? at.material.alpha : 1;
}

FrameCamera frame_camera(const PinholeCamera& camera) {
  FrameCamera out{};
  out.right = camera.camera_from_world.row(0);  // all that the lights look at
  return out;
}

}  // namespace

PathTracer::PathTracer(const PictureScene& scene, const PinholeCamera& camera,
                       const PictureOptions& options, const PathOptions& path)
    : m_options(options),
      m_path(path),
      m_camera(camera),
      m_environment(path.look.environment.get()),
      m_has_floor(scene.floor),
      m_frame(make_picture_frame(scene)),
      m_scene(scene, m_frame),
      m_frame_from_camera(camera.camera_from_world.transpose().cast<float>()),
      m_lamps(path.look, PictureLights(kSkyViews, frame_camera(camera)), m_frame),
      m_eye(m_frame.apply(camera.eye).cast<float>()),
      m_environment_share(environment_share()) {
  const PictureLights lights(kSkyViews, frame_camera(camera));
  const PictureLook& look = path.look;
  set_lens(camera, look);
  m_sky_horizon = lights.sky_colour(0).cwiseProduct(look.sky_colour).cast<float>();
  m_sky_slope = lights.sky_colour(1).cwiseProduct(look.sky_colour).cast<float>() - m_sky_horizon;
  m_floor_colour = look.floor_colour.cast<float>();
  m_floor_z = static_cast<float>(m_frame.floor_z);
  // The floor fades out in radii of the scene.
  const double radius = std::max(m_frame.radius, 0.05);
  m_fade_begin = float(kFadeBegin * radius), m_fade_end = float(kFadeEnd * radius);
}

void PathTracer::set_lens(const PinholeCamera& camera, const PictureLook& look) {
  // Without an f-number the camera is a pinhole.
  if (look.f_number <= 0) return;
  const double focal_length = kSensorWidth * camera.fx / camera.width;
  m_lens_radius = static_cast<float>(m_frame.scale * focal_length / (2 * look.f_number));
  const double middle = camera.camera_from_world.row(2).dot(m_frame.centre - camera.eye);
  m_in_focus = static_cast<float>(m_frame.scale * look.focus * std::max(middle, focal_length));
}

Vec3f PathTracer::sky(const Vec3f& direction, bool mirrored) const {
  if (m_environment) return surroundings(direction);
  // Light from below is dim where there is no floor.
  if (direction.z() < 0 && !m_has_floor) return Vec3f::Constant(kDimGround);
  const Vec3f light = m_sky_horizon + m_sky_slope * std::max(direction.z(), 0.0f);
  // Mirrors see no dark studio: a room would have walls that the key light lights.
  return mirrored ? Vec3f(light * float(0.75 / (1 - kKeyShare))) : light;
}

Vec3f PathTracer::surroundings(const Vec3f& d) const {
  const auto c = static_cast<float>(m_path.look.environment_turn.x());
  const auto s = static_cast<float>(m_path.look.environment_turn.y());
  const Vec3f turned(c * d.x() + s * d.y(), c * d.y() - s * d.x(), d.z());
  return float(m_path.look.environment_strength) * m_environment->radiance(turned);
}

void PathTracer::start_path(Path& path, int x, int y, int sample) const {
  const auto pixel = static_cast<std::uint32_t>(std::int64_t(y) * m_camera.width + x);
  path.sampler = Sampler(pixel, static_cast<std::uint32_t>(sample));
  // The pixel is met at a random place, which smooths edges.
  const Sampler::Pair u = path.sampler.next();
  const Vec3f ray(float((x + u.x - 0.5 - m_camera.cx) / m_camera.fx),
                  float((y + u.y - 0.5 - m_camera.cy) / m_camera.fy), 1);
  path.from = m_eye;
  path.direction = (m_frame_from_camera * ray).normalized();
  // A point of the lens looks at the same point in focus.
  if (m_lens_radius > 0) {
    const Sampler::Pair at = path.sampler.next();
    const float r = m_lens_radius * std::sqrt(at.x), phi = 2 * std::numbers::pi_v<float> * at.y;
    const Vec3f on_lens(r * std::cos(phi), r * std::sin(phi), 0);
    path.from += m_frame_from_camera * on_lens;
    path.direction = (m_frame_from_camera * (m_in_focus * ray - on_lens)).normalized();
  }
  path.spread = kPixelShare / float(m_camera.fx);
}

bool PathTracer::meets_floor(const Path& path, const HitPacket& hits, int lane,
                             float& distance) const {
  // Rays that rise, or start below, never meet the floor.
  if (!m_has_floor || path.direction.z() > -1e-6f || path.from.z() < m_floor_z) return false;
  const bool is_hidden =
      hits.face[lane] != kNoFace &&
      path.from.z() + hits.distance[lane] * path.direction.z() >= m_floor_z - kBelowTolerance;
  if (is_hidden) return false;
  distance = (m_floor_z - path.from.z()) / path.direction.z();
  return true;
}

SurfacePoint PathTracer::floor_point(const Path& path, float distance) const {
  SurfacePoint out;
  out.position = path.from + distance * path.direction;
  out.position.z() = m_floor_z;
  out.start = out.position;
  out.face = out.normal = Vec3f::UnitZ();
  out.outside = true;
  out.material.base = m_floor_colour;
  out.material.roughness = 0.9f;
  return out;
}

float PathTracer::floor_coverage(const Vec3f& at) const {
  if (m_environment) return 1;  // it goes on to the horizon
  return 1 - smoothstep(m_fade_begin, m_fade_end, at.head<2>().norm());
}

void PathTracer::leave(Path& path) const {
  path.on = false;
  if (m_environment && path.sees_background()) {
    path.has_seen = true, path.coverage = 1;
    return path.add(path.weight.cwiseProduct(surroundings(path.direction)));
  }
  if (!path.has_seen) return;  // the background
  // The light of matt surfaces was asked for there.
  if (m_environment && path.kind == NextRay::Kind::Matt) return;
  if (path.sees_background())
    path.uncover(path.coverage);
  else
    path.add(path.weight.cwiseProduct(sky(path.direction, path.kind == NextRay::Kind::Bright)));
}

// Notes the first surface that is seen; or the floor behind glass, which fades into the background.
void PathTracer::note(Path& path, const SurfacePoint& at, bool on_floor) const {
  const float coverage = on_floor ? floor_coverage(at.position) : 1;
  // Behind glass the floor fades into the background by its own coverage.
  if (path.has_seen) {
    if (!path.sees_background()) return;
    path.uncover((1 - coverage) * path.coverage);
    path.weight *= coverage;
    return;
  }
  path.has_seen = coverage > 0;
  path.coverage = coverage;
  path.normal = at.normal, path.position = at.position;
  if (at.material.finish != Finish::Glass) path.albedo = diffuse_albedo(at.material);
}

// In proportion to the light on a surface in the middle; each gets a part, as one may be hidden.
float PathTracer::environment_share() const {
  if (!m_environment) return 0;
  if (m_lamps.irradiance() <= 0) return 1;
  const float around = std::numbers::pi_v<float> * luminance(m_environment->mean()) *
                       float(m_path.look.environment_strength);
  return std::clamp(around / (around + m_lamps.irradiance()), kLeastLightShare,
                    1 - kLeastLightShare);
}

// Matt reflections of the environment; bright ones are found by the rays that go on.
void PathTracer::ask_environment(Path& path, const SurfacePoint& at, Sampler::Pair u) const {
  const EnvironmentMap::Drawn drawn = m_environment->draw(u);
  const auto c = static_cast<float>(m_path.look.environment_turn.x());
  // The direction is turned back into the scene.
  const auto s = static_cast<float>(m_path.look.environment_turn.y());
  const Vec3f& d = drawn.direction;
  path.key_direction = Vec3f(c * d.x() - s * d.y(), s * d.x() + c * d.y(), d.z());
  const Reflected light = reflected(at, path.key_direction, -path.direction);
  // The floor hides all light from below.
  path.asks_key = light.matt > 0 && !(m_has_floor && d.z() <= 0);
  if (!path.asks_key) return;
  path.asks_first = path.is_first();
  const auto strength = static_cast<float>(m_path.look.environment_strength);
  path.key_bright = Vec3f::Zero();
  path.key_matt = opacity_of(at) * strength * light.matt * path.weight.cwiseProduct(drawn.weight);
  // The first surface's colour is kept apart: the filter works without it.
  if (!path.asks_first) path.key_matt = path.key_matt.cwiseProduct(diffuse_albedo(at.material));
  path.key_from = lifted(at, path.key_direction), path.key_end = kRayEnd;
}

void PathTracer::ask_lamps(Path& path, const SurfacePoint& at, Sampler::Pair u) const {
  const LampLight lamp = m_lamps.towards(at.position, u);
  path.key_direction = lamp.direction;
  const Reflected light = reflected(at, path.key_direction, -path.direction);
  path.asks_key = light.matt > 0 || light.bright.maxCoeff() > 0;
  if (!path.asks_key) return;
  path.asks_first = path.is_first();
  path.key_end = lamp.distance;
  const Vec3f weight = opacity_of(at) * path.weight.cwiseProduct(lamp.irradiance);
  path.key_bright = weight.cwiseProduct(light.bright);
  path.key_matt = weight * light.matt;
  if (!path.asks_first) path.key_matt = path.key_matt.cwiseProduct(diffuse_albedo(at.material));
  path.key_from = lifted(at, path.key_direction);
}

// By one ray, to the environment or to the lamps: its light is that over the chance.
void PathTracer::ask_for_light(Path& path, const SurfacePoint& at) const {
  Sampler::Pair u = path.sampler.next();
  if (m_environment_share <= 0) return ask_lamps(path, at, u);
  if (m_environment_share >= 1) return ask_environment(path, at, u);
  const bool around = u.x < m_environment_share;
  // The rest of the random number is even again for the chosen kind of light.
  const float chance = around ? m_environment_share : 1 - m_environment_share;
  u.x = std::clamp((around ? u.x : u.x - m_environment_share) / chance, 0.0f, 0x1.fffffep-1f);
  if (around)
    ask_environment(path, at, u);
  else
    ask_lamps(path, at, u);
  if (path.asks_key) path.key_matt /= chance, path.key_bright /= chance;
}

// Along the next ray, or to the end.
void PathTracer::go_on(Path& path, const SurfacePoint& at) const {
  const Sampler::Pair choice = path.sampler.next(), at_random = path.sampler.next();
  const auto next = next_ray(at, -path.direction, choice, at_random);
  path.on = next && next->direction.allFinite();
  if (!path.on) return;
  // The first surface tells whether a path's light is matt or bright.
  if (path.is_first())
    path.matt = next->kind == NextRay::Kind::Matt;
  else if (next->kind == NextRay::Kind::Matt)
    path.weight = path.weight.cwiseProduct(diffuse_albedo(at.material));
  path.kind = next->kind;
  path.weight = path.weight.cwiseProduct(next->weight);
  path.from = next->from, path.direction = next->direction;
  if (at.material.finish == Finish::Glass)
    path.inside = next->enters, path.absorbed = at.material.absorbed;
  // Textures are looked up more coarsely the more a path has spread.
  if (path.kind == NextRay::Kind::Matt)
    path.spread = std::max(path.spread, kMattSpread);
  else if (path.kind == NextRay::Kind::Bright)
    path.spread += kBrightSpread * at.material.roughness;
  const bool passes = path.kind == NextRay::Kind::Through || path.inside;
  if (passes) path.on = ++path.num_through < kMaxThrough;
  // Passing through is no bounce: glass may have many faces.
  if (passes) return;
  ++path.num_bounces;
  if (path.kind == NextRay::Kind::Matt && !m_options.ambient_occlusion) return leave(path);
  // Faint paths end early, the others make up for them.
  const float keep = std::clamp(path.weight.maxCoeff() * kKeep, 0.05f, 1.0f);
  if (path.num_bounces < 2 || keep >= 1) return;
  path.on = path.sampler.next().x < keep;
  path.weight /= keep;
}

// On through what is cut out, as if nothing were there.
void PathTracer::pass_absent(Path& path, const SurfacePoint& at) {
  path.from = lifted(at, path.direction);
  path.on = ++path.num_absent < kMaxAbsent;
}

// From where a ray came to its hit, and on.
void PathTracer::advance(Path& path, const RayPacket& rays, const HitPacket& hits, int lane) const {
  float distance = hits.distance[lane];
  const bool on_floor = meets_floor(path, hits, lane, distance);
  if (!on_floor && hits.face[lane] == kNoFace) return leave(path);
  path.width += distance * path.spread;
  const SurfacePoint at =
      on_floor ? floor_point(path, distance) : m_scene.surface(rays, hits, lane, path.width);
  if (path.inside)
    path.weight = path.weight.cwiseProduct((-distance * path.absorbed).array().exp().matrix());
  if (at.material.finish == Finish::Absent) return pass_absent(path, at);
  note(path, at, on_floor);
  path.on = path.has_seen;
  if (!path.on) return;
  if (path.num_bounces > m_path.bounces) {
    // Paths end here: the point is lit as the surroundings are.
    const Vec3f dim = kFromNeighbours * diffuse_albedo(at.material);
    const Vec3f around =
        m_environment ? Vec3f(float(m_path.look.environment_strength) * m_environment->mean())
                      : sky(Vec3f::UnitZ(), false);
    path.add(path.weight.cwiseProduct(dim.cwiseProduct(around)));
    path.on = false;
    return;
  }
  if (at.material.emitted.maxCoeff() > 0)
    path.add((opacity_of(at) * path.weight).cwiseProduct(at.material.emitted));
  // A surface is lit directly first, then by all that the path meets later.
  ask_for_light(path, at);
  go_on(path, at);
}

void PathTracer::follow(std::array<Path, kRayLanes>& paths) const {
  const auto is_on = [](const Path& path) { return path.on; };
  while (std::any_of(paths.begin(), paths.end(), is_on)) {
    RayPacket rays{}, shadows{};
    // All paths of a block go on together: one packet of rays, one of shadows.
    for (int i = 0; i < kRayLanes; ++i)
      if (paths[i].on) rays.set(i, paths[i].from, paths[i].direction, 0, kRayEnd);
    const HitPacket hits = m_scene.rays().first_hits(rays);
    bool any_shadow = false;
    for (int i = 0; i < kRayLanes; ++i) {
      Path& path = paths[i];
      path.asks_key = false;
      if (path.on) advance(path, rays, hits, i);
      if (!path.asks_key || !m_options.shadows) continue;
      // Shadows are asked only for light that would count.
      shadows.set(i, path.key_from, path.key_direction, 0, path.key_end);
      any_shadow = true;
    }
    std::array<Vec3f, kRayLanes> passed;
    passed.fill(Vec3f::Ones());
    if (any_shadow) passed = m_scene.rays().passed(shadows);
    for (int i = 0; i < kRayLanes; ++i)
      if (paths[i].asks_key) paths[i].add_key(passed[i]);
  }
}

}  // namespace trivet
