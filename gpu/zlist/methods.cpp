#include "gpu/zlist/methods.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>

#include "core/base/error.h"
#include "gpu/zlist/device.h"
#include "gpu/zlist/measured_shapes.h"

namespace trivet {
namespace {

/// Rows and columns of the spheres' quadrilaterals; on the CPU the smaller ones tell as much.
constexpr int kRows = 75, kRowsOnCpu = 20;
constexpr int kRepeats = 3;

double milliseconds_of(CandidateFinder& stage, const FirstContactQuery& query) {
  const auto start = std::chrono::steady_clock::now();
  if (!stage.find_candidates(query, query.motion.limit).usable) return kInfinity;
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

/// The least of several, after one that compiles shaders and sends meshes.
double time_of(CandidateFinder& stage, const Shape& sphere) {
  const Body fixed(sphere, world_from_object({}, UpAxis::Z, 1));
  const Body moving(sphere, world_from_object({{}, Vec3(0.3, 0.2, 3)}, UpAxis::Z, 0.5));
  double sum = 0;
  // A fall and a turn count alike.
  for (const Motion& motion : {Motion::translation(-Vec3::UnitZ(), 3),
                               Motion::rotation(Vec3(2.5, 0, 1), -Vec3::UnitY(), 1)}) {
    const FirstContactQuery query{{&moving, 1}, {&fixed, 1}, false, motion, {1e-6}};
    milliseconds_of(stage, query);
    double least = kInfinity;
    for (int i = 0; i < kRepeats; ++i) least = std::min(least, milliseconds_of(stage, query));
    sum += least;
  }
  return sum / 2;
}

/// Null where it cannot be had.
std::unique_ptr<CandidateFinder> try_method(GpuZListOptions options, GpuMethod method) {
  options.method = method;
  try {
    return make_gpu_candidate_finder(options);
  } catch (const Error&) {
    return nullptr;
  }
}

GpuMethodTimes measure(GpuZListOptions options, bool on_cpu) {
  options.bounds_alone = false;
  const auto sphere = bumpy_sphere(on_cpu ? kRowsOnCpu : kRows);
  GpuMethodTimes out{kInfinity, kInfinity};
  if (const auto stage = try_method(options, GpuMethod::Framebuffer))
    out.framebuffer_ms = time_of(*stage, *sphere);
  if (const auto stage = try_method(options, GpuMethod::Compute))
    out.compute_ms = time_of(*stage, *sphere);
  return out;
}

/// Measurements of this process, by renderer and the OpenGL version asked for.
struct Known {
  std::mutex mutex;
  std::map<std::pair<std::string, int>, GpuMethodTimes> times;
};

Known& known() {
  static Known instance;
  return instance;
}

std::optional<GpuMethodTimes> known_times(const EglContext& context,
                                          const GpuZListOptions& options) {
  const std::lock_guard lock(known().mutex);
  const auto found = known().times.find({context.renderer(), options.most_gl_version});
  if (found == known().times.end()) return std::nullopt;
  return found->second;
}

}  // namespace

GpuMethod gpu_method_from_name(const std::string& name) {
  if (name == "auto") return GpuMethod::Auto;
  if (name == "framebuffer") return GpuMethod::Framebuffer;
  if (name == "compute") return GpuMethod::Compute;
  throw Error(Error::Kind::BadInput,
              "GPU method \"%1\" is not accepted; accepted: auto, framebuffer, compute", name);
}

GpuMethodTimes measure_gpu_methods(const GpuZListOptions& options) {
  const EglContext context(egl_options(options));
  const GpuMethodTimes times = measure(options, context.is_software());
  const std::lock_guard lock(known().mutex);
  known().times[{context.renderer(), options.most_gl_version}] = times;
  return times;
}

std::unique_ptr<CandidateFinder> make_faster_candidate_finder(GpuZListOptions options) {
  // Without OpenGL 4.3 there is nothing to choose.
  options.method = GpuMethod::Framebuffer;
  const EglContext context(egl_options(options));
  if (std::min(context.gl_version(), options.most_gl_version) < 43)
    return make_gpu_candidate_finder(options);
  std::optional<GpuMethodTimes> times = known_times(context, options);
  // Its compiler takes seconds for the shaders of both, and there compute shaders are faster.
  if (!times && context.is_software()) times = {kInfinity, 0};
  if (!times) times = measure_gpu_methods(options);
  options.method = times->faster();
  return make_gpu_candidate_finder(options);
}

}  // namespace trivet
