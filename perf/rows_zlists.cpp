// z-lists against box trees on the same motions, and thousands of places at once.
#include <tbb/global_control.h>

#include "core/base/error.h"
#include "perf/rows.h"
#include "perf/sweeps.h"
#include "raster/height_map.h"
#include "raster/software_zlists.h"
#ifdef TRIVET_PERF_GPU
#include "gpu/drop_brackets_gpu.h"
#include "gpu/zlist_gpu.h"
#endif

namespace trivet::perf {
namespace {

constexpr int kSweeps = 12;
constexpr double kBudget_ms = 5000;  // for a row; then the rest of the sweeps is left out
constexpr int kPlaces = 64;          // by 64

struct Asked {
  Sweep sweep;
  FirstContact truth;
};

std::vector<Asked> sweeps_of(const SpherePair& spheres, Motion::Kind kind, Row& row) {
  test::Random random(23);
  std::vector<Asked> out;
  for (int i = 0; i < kSweeps; ++i) {
    Asked a{kind == Motion::Kind::Translation ? random_drop(spheres, random)
                                              : random_turn(spheres, random),
            {}};
    row.samples.add(timed_warm([&] { a.truth = a.sweep.first_contact(); }));
    out.push_back(a);
  }
  return out;
}

bool same(const FirstContact& a, const FirstContact& b) {
  return a.status == b.status && a.time == b.time && a.face_moving == b.face_moving &&
         a.face_fixed == b.face_fixed;
}

// What the stages left over, summed up and divided.
struct Left {
  double pixels = 0, doubtful = 0, pairs = 0, bytes = 0;
  int count = 0, wrong = 0, unusable = 0;

  void add(const Proposal& p, bool right) {
    ++count;
    wrong += !right;
    unusable += !p.usable;
    pixels += static_cast<double>(p.work.pixels);
    doubtful += static_cast<double>(p.work.doubtful_pixels);
    pairs += static_cast<double>(p.work.face_pairs);
    bytes += static_cast<double>(p.work.bytes_read_back);
  }
  std::string text_of() const {
    std::string out = text("means: %.0f pixels, %.0f doubtful, %.0f pairs left", pixels / count,
                           doubtful / count, pairs / count);
    if (bytes > 0) out += text(", %.0f bytes read back", bytes / count);
    if (unusable > 0) out += text("; gave up %d of %d", unusable, count);
    return out + (wrong > 0 ? text("; WRONG %d", wrong) : "; the same bits");
  }
};

void add_stage(const std::string& what, const std::vector<Asked>& sweeps, ZListStage& stage,
               double goal_ms, double bvh_cpu_ms, Report& report) {
  Row row{what, {}, goal_ms, 0, ""};
  Left left;
  double spent_ms = 0;
  for (const Asked& a : sweeps) {
    if (spent_ms > kBudget_ms) break;
    const Body moving = a.sweep.moving(), fixed = a.sweep.fixed();
    const FirstContactQuery query{
        {&moving, 1}, {&fixed, 1}, false, a.sweep.motion, a.sweep.clearance};
    FirstContact found;
    Proposal proposal;
    const Took took = timed_warm([&] { found = first_contact(query, stage, &proposal); });
    row.samples.add(took);
    spent_ms += 2 * took.wall_ms;
    left.add(proposal, same(found, a.truth));
  }
  row.ours_ms = bvh_cpu_ms;
  row.outcome = left.text_of();
  report.add(std::move(row));
}

double software_goal_ms(int num_triangles, Motion::Kind kind) {
  if (kind != Motion::Kind::Translation) return 0;
  return num_triangles == 15'000 ? 1.5 : num_triangles == 1'000'000 ? 35 : 0;
}

void software_rows(const std::vector<Asked>& sweeps, int num_triangles, double bvh_ms,
                   Report& report) {
  const double goal = software_goal_ms(num_triangles, sweeps[0].sweep.motion.kind);
  for (const int resolution : {0, 128, 512, 1024})
    for (const int threads : {1, 2}) {
      if (threads == 2 && resolution != 0) continue;
      const tbb::global_control cores(tbb::global_control::max_allowed_parallelism, threads);
      SoftwareZListOptions options;
      options.resolution = resolution;
      options.num_threads = threads;
      SoftwareZLists stage(options);
      const std::string pixels = resolution == 0 ? "own choice of" : std::to_string(resolution);
      add_stage(text("software z-lists, %s pixels, %d thread%s", pixels.c_str(), threads,
                     threads > 1 ? "s" : ""),
                sweeps, stage, resolution == 0 && threads == 1 ? goal : 0, bvh_ms, report);
    }
}

void gpu_rows([[maybe_unused]] const std::vector<Asked>& sweeps, [[maybe_unused]] Report& report) {
#ifdef TRIVET_PERF_GPU
  for (const bool fallback : {false, true})
    for (const int resolution : {128, 512}) try {
        GpuZListOptions options;
        options.resolution = resolution;
        options.force_fallback = fallback;
        const auto stage = make_gpu_zlist_stage(options);
        // No ratio: the calling thread's CPU time is not what a GPU, or llvmpipe's threads, take.
        add_stage(stage->name() + ", " + std::to_string(resolution) + " pixels", sweeps, *stage, 0,
                  0, report);
      } catch (const Error& e) {
        report.remark("z-lists on the GPU", e.what());
      }
#endif
}

void rows_of(int num_triangles, Report& report) {
  const SpherePair spheres = make_sphere_pair(num_triangles);
  for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation}) {
    const std::string size = short_count(num_triangles);
    report.section("Sources of candidates, " + size + " triangles against " + size + ", " +
                   (kind == Motion::Kind::Translation ? "drop" : "quarter turn"));
    Row row{"box trees", {}, 0, 0, "prepared once per mesh; the others ask nothing of a mesh"};
    const std::vector<Asked> sweeps = sweeps_of(spheres, kind, row);
    const double bvh_ms = row.samples.median_cpu_ms();
    report.add(std::move(row));
    software_rows(sweeps, num_triangles, bvh_ms, report);
    if (num_triangles <= 150'000) gpu_rows(sweeps, report);
  }
}

// The maps of a bumpy sphere of 15K triangles over another, at 64 x 64 places.
void place_rows(Report& report) {
  report.section("Where does it fit: 4,096 places of 15K triangles over 15K triangles");
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
#ifdef TRIVET_PERF_GPU
  try {
    GpuDropBrackets gpu;
    Row row{"gpu (" + gpu.name() + "), all places, maps sent and brackets read", {}, 0, 0, ""};
    std::vector<DropBracket> found;
    for (int i = 0; i < 20; ++i)
      row.samples.add(timed_warm([&] { found = gpu(underside, top, kPlaces, kPlaces); }));
    size_t different = 0;
    for (size_t i = 0; i < truth.size(); ++i)
      different += found[i].lower != truth[i].lower || found[i].upper != truth[i].upper;
    row.outcome = different > 0 ? text("WRONG %zu", different) : "the same bits";
    report.add(std::move(row));
  } catch (const Error& e) {
    report.remark("places on the GPU", e.what());
  }
#endif
}

}  // namespace

void zlist_rows(Report& report) {
  for (const int num_triangles : {1'000, 15'000, 150'000, 1'000'000, 1'500'000})
    rows_of(num_triangles, report);
  place_rows(report);
}

}  // namespace trivet::perf
