#include "core/base/error.h"
#include "perf/frame_time.h"
#include "perf/gpu_stages.h"
#ifdef TRIVET_PERF_GPU
#include "gpu/live/view.h"
#include "gpu/zlist/stage.h"
#include "raster/zlist/software_zlists.h"
#endif

namespace trivet::perf {

#ifdef TRIVET_PERF_GPU
namespace {

constexpr int kFrames = 9;

LiveScene live_scene(const Scene& scene) {
  LiveScene out;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    LiveObject live;
    live.model = object.model;
    live.world_from_object = object.world_from_object();
    out.objects.push_back(live);
  }
  return out;
}

GpuZListOptions options_of(GpuMethod method) {
  GpuZListOptions options;
  options.method = method;
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>();
  return options;
}

}  // namespace

std::vector<GpuSource> gpu_stages() {
  std::vector<GpuSource> out;
  for (const GpuMethod method : {GpuMethod::Framebuffer, GpuMethod::Compute})
    out.push_back({method == GpuMethod::Compute ? "compute shaders" : "framebuffers",
                   [=](bool allow_software, const GpuNotes& notes) {
                     GpuZListOptions options = options_of(method);
                     options.allow_software = allow_software;
                     options.notes = notes;
                     return make_gpu_candidate_finder(options);
                   }});
  return out;
}

std::vector<StagedFinder> staged_gpu_finders() {
  std::vector<StagedFinder> out;
  for (const GpuMethod method : {GpuMethod::Framebuffer, GpuMethod::Compute})
    for (const GpuListing listing : {GpuListing::Gpu, GpuListing::Software}) {
      GpuZListOptions options = options_of(method);
      options.listing = listing;
      StagedFinder finder;
      finder.whole = make_gpu_candidate_finder(options);
      finder.name = finder.whole->name() +
                    (listing == GpuListing::Gpu ? ", lists by the GPU" : ", lists in software");
      options.bounds_alone = true;
      finder.depths = make_gpu_candidate_finder(options);
      out.push_back(std::move(finder));
    }
  return out;
}

std::string frame_text(const Scene& scene, Report& report) try {
  EglContext context;
  LiveView view(context);
  LiveScene live = live_scene(scene);
  LiveCamera camera;
  const Aabb box = scene.box();
  camera.target = box.centre();
  camera.eye = camera.target + Vec3(1, -2, 1.5);
  camera = framed(camera, box, 16.0 / 9);
  LiveOptions options;
  options.width = 1280, options.height = 720;
  view.draw(live, camera, options);
  Row row{"a frame of 1280 x 720, an object moved, " + context.renderer(), {}, 0, 0, ""};
  for (int i = 0; i < kFrames; ++i) {
    live.objects.back().world_from_object.translation.z() += 1e-3;
    row.samples.add(timed([&] { view.draw(live, camera, options); }, CLOCK_PROCESS_CPUTIME_ID));
  }
  const std::string out = text("%.0f", row.samples.median_ms());
  report.add(std::move(row));
  return out;
} catch (const Error& error) {
  report.remark("a frame of 1280 x 720", error.what());
  return "-";
}
#else
std::vector<GpuSource> gpu_stages() { return {}; }
std::vector<StagedFinder> staged_gpu_finders() { return {}; }
std::string frame_text(const Scene&, Report&) { return "-"; }
#endif

}  // namespace trivet::perf
