// z-lists against BVHs on the same motions.
#include <tbb/global_control.h>

#include "core/base/error.h"
#include "ops/base/stopwatch.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/sweeps.h"
#include "raster/zlist/software_zlists.h"
#ifdef TRIVET_PERF_GPU
#include "gpu/zlist/zlist_gpu.h"
#endif

namespace trivet::perf {
namespace {

constexpr int kSweeps = 12;
constexpr double kBudget_ms = 2000;  // for a row; then the remaining sweeps are skipped
constexpr double kLong_ms = 400;     // longer queries are not repeated with warm caches
constexpr int kResolutions[] = {0, 128, 256, 512, 1024};  // 0: automatic
constexpr int kGpuResolutions[] = {0, 128, 512};

constexpr const char* kColumns =
    "motion,triangles,method,resolution,median_ms,p95_ms,cpu_ms,queries,pixels,doubtful_pixels,"
    "pairs,bytes_read_back,given_up";

struct Asked {
  Sweep sweep;
  FirstContact truth;
};

// All queries of one size and motion, and the target of their rows.
struct Cases {
  int num_triangles = 0;
  Motion::Kind kind = Motion::Kind::Translation;
  std::vector<Asked> sweeps;
  double bvh_cpu_ms = 0;
  Report* report = nullptr;
  /// Hash of the BVHs' answers and of all differing answers of others: the number of queries to
  /// others depends on their time.
  ResultHash* hash = nullptr;
};

// A candidate finder.
struct Method {
  std::string name;    // of a series in the plot
  std::string what;    // of a row
  int resolution = 0;  // 0: automatic
  double goal_ms = 0;
  bool compares = true;       // compared with the CPU time of BVHs
  bool bounds_alone = false;  // computes bounds, no candidates
};

bool same_answer(const FirstContact& a, const FirstContact& b) {
  return a.status == b.status && a.time == b.time && a.face_moving == b.face_moving &&
         a.face_fixed == b.face_fixed;
}

// Sums of the work left by the stages, for means.
struct Left {
  double pixels = 0, doubtful = 0, pairs = 0, bytes = 0;
  int count = 0, wrong = 0, unusable = 0;

  void add(const CandidatePairs& p, bool right) {
    ++count;
    wrong += !right;
    unusable += !p.usable;
    pixels += static_cast<double>(p.work.pixels);
    doubtful += static_cast<double>(p.work.doubtful_pixels);
    pairs += static_cast<double>(p.work.face_pairs);
    bytes += static_cast<double>(p.work.bytes_read_back);
  }
  std::string text_of(bool bounds_alone) const {
    std::string out = text("means: %.0f pixels, %.0f doubtful", pixels / count, doubtful / count);
    if (!bounds_alone) out += text(", %.0f pairs left", pairs / count);
    if (bytes > 0) out += text(", %.0f bytes read back", bytes / count);
    if (unusable > 0 && !bounds_alone) out += text("; gave up %d of %d", unusable, count);
    if (wrong > 0) return out + text("; WRONG %d", wrong);
    return out + (bounds_alone ? "; the bounds hold" : "; the same bits");
  }
};

void add_data(const Cases& cases, const Method& method, const Samples& samples, const Left& left) {
  const double count = std::max(1, left.count);
  cases.report->add_data(text("%s,%d,\"%s\",%d,%.5g,%.5g,%.5g,%zu,%.6g,%.6g,%.6g,%.6g,%d",
                              cases.kind == Motion::Kind::Translation ? "drop" : "turn",
                              cases.num_triangles, method.name.c_str(), method.resolution,
                              samples.median_ms(), samples.p95_ms(), samples.median_cpu_ms(),
                              samples.count(), left.pixels / count, left.doubtful / count,
                              left.pairs / count, left.bytes / count, left.unusable));
}

void ask_bvhs(const SpherePair& spheres, Cases& cases) {
  Row row{"BVHs", {}, 0, 0, "built once per mesh; the others need no preprocessing"};
  test::Random random(23);
  Left left;
  for (int i = 0; i < kSweeps; ++i) {
    Asked a{cases.kind == Motion::Kind::Translation ? random_drop(spheres, random)
                                                    : random_turn(spheres, random),
            {}};
    row.samples.add(timed_warm([&] { a.truth = a.sweep.first_contact(); }));
    cases.hash->add(a.truth);
    left.pairs += static_cast<double>(a.truth.work.face_pairs);
    ++left.count;
    cases.sweeps.push_back(a);
  }
  cases.bvh_cpu_ms = row.samples.median_cpu_ms();
  add_data(cases, {"box trees", "", 0}, row.samples, left);
  cases.report->add(std::move(row));
}

// Returns whether a stage's answer equals that of the BVHs; if not, hashes it.
bool is_right(const FirstContact& found, const FirstContact& truth, ResultHash& hash) {
  const bool right = same_answer(found, truth);
  if (!right) hash.add(found);
  return right;
}

bool holds(const CandidatePairs& proposal, const FirstContact& truth, ResultHash& hash) {
  const double time = truth.status == FirstContact::Status::Free ? kInfinity : truth.time;
  const bool right =
      proposal.lower <= time && (time <= proposal.upper || proposal.upper == kInfinity);
  if (!right) hash.add(proposal.lower), hash.add(proposal.upper);
  return right;
}

// CPU times include all threads, as a driver may have its own.
bool ask_stage(CandidateFinder& stage, const FirstContactQuery& query, const Method& method,
               const Asked& asked, const Cases& cases, Samples& samples, CandidatePairs& proposal) {
  FirstContact found;
  const auto ask = [&] {
    if (method.bounds_alone)
      proposal = stage.find_candidates(query, query.motion.limit);
    else
      found = first_contact(query, stage, &proposal);
  };
  const Took first = timed(ask, CLOCK_PROCESS_CPUTIME_ID);
  samples.add(first.wall_ms > kLong_ms ? first : timed(ask, CLOCK_PROCESS_CPUTIME_ID));
  return method.bounds_alone ? holds(proposal, asked.truth, *cases.hash)
                             : is_right(found, asked.truth, *cases.hash);
}

void add_stage(const Cases& cases, const Method& method, CandidateFinder& stage) {
  Row row{method.what, {}, method.goal_ms, method.compares ? cases.bvh_cpu_ms : 0, ""};
  Left left;
  const Stopwatch stopwatch;
  for (const Asked& a : cases.sweeps) {
    if (stopwatch.elapsed().wall_ms > kBudget_ms) break;
    const Body moving = a.sweep.moving(), fixed = a.sweep.fixed();
    const FirstContactQuery query{
        {&moving, 1}, {&fixed, 1}, false, a.sweep.motion, a.sweep.clearance};
    CandidatePairs proposal;
    const bool right = ask_stage(stage, query, method, a, cases, row.samples, proposal);
    left.add(proposal, right);
  }
  add_data(cases, method, row.samples, left);
  row.outcome = left.text_of(method.bounds_alone);
  cases.report->add(std::move(row));
}

double software_goal_ms(const Cases& cases) {
  if (cases.kind != Motion::Kind::Translation) return 0;
  return cases.num_triangles == 15'000 ? 1.5 : cases.num_triangles == 1'000'000 ? 35 : 0;
}

void software_rows(const Cases& cases) {
  for (const int threads : {1, 2}) {
    const tbb::global_control cores(tbb::global_control::max_allowed_parallelism, threads);
    const std::string suffix = text("%d thread%s", threads, threads > 1 ? "s" : "");
    for (const int resolution : kResolutions) {
      SoftwareZListOptions options;
      options.resolution = resolution;
      options.num_threads = threads;
      SoftwareZLists stage(options);
      Method method{"software, " + suffix, "", resolution};
      method.what = "software z-lists, ";
      method.what += resolution == 0 ? "own choice of" : std::to_string(resolution);
      method.what += " pixels, " + suffix;
      if (resolution == 0 && threads == 1) method.goal_ms = software_goal_ms(cases);
      add_stage(cases, method, stage);
    }
  }
}

#ifdef TRIVET_PERF_GPU
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

void gpu_rows(const Cases& cases) {
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
#endif

void rows_of(int num_triangles, Report& report) {
  const SpherePair spheres = make_sphere_pair(num_triangles);
  for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation}) {
    const std::string size = short_count(num_triangles);
    report.section("Candidate finders, " + size + " triangles against " + size + ", " +
                   (kind == Motion::Kind::Translation ? "drop" : "quarter turn"));
    ResultHash hash;
    Cases cases{num_triangles, kind, {}, 0, &report, &hash};
    ask_bvhs(spheres, cases);
    software_rows(cases);
#ifdef TRIVET_PERF_GPU
    if (num_triangles != 1'000'000) {  // 150K and 1.5M suffice, and it is slow
      gpu_rows(cases);
      gpu_batch_row(cases, GpuMethod::Framebuffer);
      gpu_batch_row(cases, GpuMethod::Compute);
    }
#endif
    report.add_hash(hash.value());
  }
}

}  // namespace

void zlist_rows(Report& report) {
  report.add_data(kColumns);
  for (const int num_triangles : {1'000, 15'000, 150'000, 1'000'000, 1'500'000})
    rows_of(num_triangles, report);
  place_rows(report);
}

}  // namespace trivet::perf
