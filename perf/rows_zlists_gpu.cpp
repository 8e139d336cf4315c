// z-lists on the GPU.
#include "core/base/error.h"
#include "gpu/zlist/stage.h"
#include "perf/zlist_cases.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::perf {
namespace {

constexpr int kGpuResolutions[] = {0, 128, 512};

// A way of the GPU stage.
struct GpuWay {
  const char* series;
  GpuMethod method;
  int gl_version;
  GpuListing listing;
  bool bounds_alone;
};

// Depths alone, then with lists, so that the difference is the cost of the lists.
constexpr GpuWay kGpuWays[] = {
    {"framebuffers, depths", GpuMethod::Framebuffer, 46, GpuListing::Gpu, true},
    {"framebuffers", GpuMethod::Framebuffer, 46, GpuListing::Gpu, false},
    {"framebuffers, software lists", GpuMethod::Framebuffer, 46, GpuListing::Software, false},
    {"compute, depths", GpuMethod::Compute, 46, GpuListing::Gpu, true},
    {"compute", GpuMethod::Compute, 46, GpuListing::Gpu, false},
    {"compute, software lists", GpuMethod::Compute, 46, GpuListing::Software, false},
    {"framebuffers, OpenGL 3.3", GpuMethod::Framebuffer, 33, GpuListing::Gpu, false},
};

GpuZListOptions options_of(const GpuWay& way, int resolution) {
  GpuZListOptions options;
  options.resolution = resolution;
  options.method = way.method;
  options.most_gl_version = way.gl_version;
  options.bounds_alone = way.bounds_alone;
  options.listing = way.listing;
  if (way.listing == GpuListing::Software)
    options.software_lists = std::make_shared<SoftwareDoubtfulLists>();
  return options;
}

void gpu_row(const Cases& cases, const GpuWay& way, int resolution) {
  const auto stage = make_gpu_candidate_finder(options_of(way, resolution));
  Method method{way.series, stage->name(), resolution};
  method.what += resolution == 0 ? ", own choice of pixels, " : text(", %d pixels, ", resolution);
  method.what += way.bounds_alone                      ? "depths alone"
                 : way.listing == GpuListing::Software ? "lists in software"
                                                       : "complete";
  method.compares = false;
  method.bounds_alone = way.bounds_alone;
  add_stage(cases, method, *stage);
}

void single_rows(const Cases& cases) {
  for (const GpuWay& way : kGpuWays)
    for (const int resolution : kGpuResolutions) try {
        if (way.gl_version == 33 && cases.num_triangles > 150'000) break;
        gpu_row(cases, way, resolution);
      } catch (const Error& e) {
        cases.report->remark("z-lists on the GPU", e.what());
      }
}

// All sweeps in one pass, as layers of one image.
void gpu_batch_row(const Cases& cases, GpuMethod method) try {
  if (cases.num_triangles > 15'000) return;
  GpuZListOptions options;
  options.resolution = 128;
  options.method = method;
  const auto stage = make_gpu_candidate_finder(options);
  std::vector<Body> bodies;
  for (const Asked& a : cases.sweeps) {
    bodies.push_back(a.sweep.moving());
    bodies.push_back(a.sweep.fixed());
  }
  std::vector<FirstContactQuery> queries;
  for (size_t i = 0; i < cases.sweeps.size(); ++i)
    queries.push_back({{&bodies[2 * i], 1},
                       {&bodies[2 * i + 1], 1},
                       false,
                       cases.sweeps[i].sweep.motion,
                       cases.sweeps[i].sweep.clearance});
  Row row{stage->name() + text(", 128 pixels, all %zu together", queries.size()), {}, 0, 0, ""};
  std::vector<FirstContact> found;
  std::vector<CandidatePairs> proposals;
  for (int i = 0; i < 5; ++i) {
    const auto ask = [&] { found = first_contacts(queries, *stage, &proposals); };
    const Took took = timed(ask, CLOCK_PROCESS_CPUTIME_ID);
    if (i > 0) row.samples.add(took);
  }
  Left left;
  for (size_t i = 0; i < queries.size(); ++i)
    left.add(proposals[i], is_right(found[i], cases.sweeps[i].truth, *cases.hash));
  row.outcome =
      text("%.3g ms a query; ", row.samples.median_ms() / static_cast<double>(queries.size())) +
      left.text_of(false);
  cases.report->add(std::move(row));
} catch (const Error& e) {
  cases.report->remark("z-lists on the GPU", e.what());
}

}  // namespace

void zlist_gpu_rows(const Cases& cases) {
  single_rows(cases);
  gpu_batch_row(cases, GpuMethod::Framebuffer);
  gpu_batch_row(cases, GpuMethod::Compute);
}

}  // namespace trivet::perf
