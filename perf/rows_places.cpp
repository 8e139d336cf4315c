// Thousands of places at once.
#include <tbb/global_control.h>

#include "core/base/error.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/sweeps.h"
#include "raster/height_map/height_map.h"
#ifdef TRIVET_PERF_GPU
#include "gpu/zlist/drop_brackets_gpu.h"
#endif

namespace trivet::perf {
namespace {

constexpr int kPlaces = 64;  // by 64

#ifdef TRIVET_PERF_GPU
void gpu_place_row(const HeightMap& underside, const HeightMap& top,
                   const std::vector<DropBracket>& truth, Report& report, ResultHash& hash) try {
  GpuDropBrackets gpu;
  Row row{"gpu (" + gpu.name() + "), all places, maps sent and brackets read", {}, 0, 0, ""};
  std::vector<DropBracket> found;
  for (int i = 0; i < 20; ++i)
    row.samples.add(timed_warm([&] { found = gpu(underside, top, kPlaces, kPlaces); }));
  size_t different = 0;
  for (size_t i = 0; i < truth.size(); ++i) {
    if (found[i].lower == truth[i].lower && found[i].upper == truth[i].upper) continue;
    ++different;
    hash.add(found[i].lower), hash.add(found[i].upper);
  }
  row.outcome = different > 0 ? text("WRONG %zu", different) : "the same bits";
  report.add(std::move(row));
} catch (const Error& e) {
  report.remark("places on the GPU", e.what());
}
#endif

}  // namespace

// The maps of a bumpy sphere of 15K triangles over another, at 64 x 64 places.
void place_rows(Report& report) {
  report.section("Free places: 4,096 places of 15K triangles over 15K triangles");
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  const SpherePair spheres = make_sphere_pair(15'000);
  const Body object(*spheres.moving, world_from_object({{}, Vec3(0, 0, 3)}, UpAxis::Z, 0.2));
  const Body scene(*spheres.fixed, world_from_object({}, UpAxis::Z, 1));
  const MapGrid grid = MapGrid::about(object.world_box, object.world_box.half_extent().x() / 20, 0);
  MapGrid under = MapGrid::about(scene.world_box, grid.pixel, 0);
  under.width = grid.width + kPlaces - 1;
  under.height = grid.height + kPlaces - 1;
  Row rasters{"both maps, drawn once", {}, 0, 0, ""};
  Row software{"software, all places", {}, 5e-3 * kPlaces * kPlaces, 0, ""};
  HeightMap underside, top;
  std::vector<DropBracket> truth;
  for (int i = 0; i < 20; ++i) {
    rasters.samples.add(timed([&] {
      underside = draw_underside({&object, 1}, grid, 1e-6);
      top = draw_top({&scene, 1}, under, false);
    }));
    software.samples.add(timed([&] { truth = drop_brackets(underside, top, kPlaces, kPlaces); }));
  }
  rasters.outcome = text("%d x %d pixels of the object", underside.width, underside.height);
  software.outcome =
      text("%.2f microseconds a place", 1e3 * software.samples.median_cpu_ms() / truth.size());
  report.add(std::move(rasters));
  report.add(std::move(software));
  ResultHash hash;
  for (const DropBracket& b : truth) hash.add(b.lower), hash.add(b.upper);
#ifdef TRIVET_PERF_GPU
  gpu_place_row(underside, top, truth, report, hash);
#endif
  report.add_hash(hash.value());
}

}  // namespace trivet::perf
