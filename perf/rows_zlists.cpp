// z-lists against BVHs on the same motions.
#include <tbb/global_control.h>

#include "ops/base/stopwatch.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/zlist_cases.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::perf {
namespace {

constexpr int kSweeps = 12;
constexpr double kBudget_ms = 2000;  // for a row; then the remaining sweeps are skipped
constexpr double kLong_ms = 400;     // longer queries are not repeated with warm caches
constexpr int kResolutions[] = {0, 128, 256, 512, 1024};  // 0: automatic

constexpr const char* kColumns =
    "motion,triangles,method,resolution,median_ms,p95_ms,cpu_ms,queries,pixels,doubtful_pixels,"
    "pairs,bytes_read_back,given_up";

bool same_answer(const FirstContact& a, const FirstContact& b) {
  return a.status == b.status && a.time == b.time && a.face_moving == b.face_moving &&
         a.face_fixed == b.face_fixed;
}

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

}  // namespace

bool is_right(const FirstContact& found, const FirstContact& truth, ResultHash& hash) {
  const bool right = same_answer(found, truth);
  if (!right) hash.add(found);
  return right;
}

namespace {

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

}  // namespace

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

namespace {

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

void rows_of(int num_triangles, Report& report) {
  const SpherePair spheres = make_sphere_pair(num_triangles);
  for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation}) {
    const std::string size = short_count(num_triangles);
    report.section(text("Candidate finders, %s triangles against %s, %s", size.c_str(),
                        size.c_str(), kind == Motion::Kind::Translation ? "drop" : "quarter turn"));
    ResultHash hash;
    Cases cases{num_triangles, kind, {}, 0, &report, &hash};
    ask_bvhs(spheres, cases);
    software_rows(cases);
#ifdef TRIVET_PERF_GPU
    zlist_gpu_rows(cases);
#endif
    report.add_hash(hash.value());
  }
}

}  // namespace

void zlist_rows(Report& report) {
  report.add_data(kColumns);
  for (const int num_triangles : {1'000, 15'000, 150'000, 1'000'000, 1'500'000})
    rows_of(num_triangles, report);
}

}  // namespace trivet::perf
