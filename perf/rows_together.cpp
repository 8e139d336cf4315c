// Queries that share a draw of a GPU, beside the same queries one at a time.
#include "core/base/error.h"
#include "gpu/zlist/stage.h"
#include "perf/rows.h"
#include "perf/zlist_cases.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::perf {
namespace {

constexpr int kQueries = 32, kPasses = 5;
constexpr double kLongest_ms = 60;  // of a query; meshes that take longer are left out

struct Many {
  std::vector<Body> bodies;  // two of each query
  std::vector<FirstContactQuery> queries;
  std::vector<FirstContact> truth;
};

Many random_queries(const SpherePair& spheres, Motion::Kind kind) {
  Many out;
  std::vector<Sweep> sweeps;
  test::Random random(29);
  for (int i = 0; i < kQueries; ++i) {
    sweeps.push_back(kind == Motion::Kind::Translation ? random_drop(spheres, random)
                                                       : random_turn(spheres, random));
    out.bodies.push_back(sweeps.back().moving());
    out.bodies.push_back(sweeps.back().fixed());
    out.truth.push_back(sweeps.back().first_contact());
  }
  for (size_t i = 0; i < sweeps.size(); ++i)
    out.queries.push_back({{&out.bodies[2 * i], 1},
                           {&out.bodies[2 * i + 1], 1},
                           false,
                           sweeps[i].motion,
                           sweeps[i].clearance});
  return out;
}

struct Shared {
  Samples samples;  // of all queries, by the clock
  std::int64_t draws = 0, read_backs = 0;
  bool right = true;
};

// All queries, so many to a call.
void ask_all(const Many& many, size_t together, CandidateFinder& stage, Shared& out) {
  out.draws = out.read_backs = 0;
  std::vector<FirstContact> found;
  out.samples.add(timed([&] {
    for (size_t i = 0; i < many.queries.size(); i += together) {
      std::vector<CandidatePairs> proposals;
      const auto some =
          first_contacts(std::span(many.queries).subspan(i, together), stage, &proposals);
      found.insert(found.end(), some.begin(), some.end());
      for (const CandidatePairs& p : proposals) {
        out.draws += p.work.draws;
        out.read_backs += p.work.read_backs;
      }
    }
  }));
  ResultHash unused;
  for (size_t i = 0; i < found.size(); ++i)
    out.right = out.right && is_right(found[i], many.truth[i], unused);
}

double ms_a_query(const Shared& shared) {
  return shared.samples.median_ms() / static_cast<double>(kQueries);
}

// A query together with n - 1 others takes its own time, and 1/n of what a draw and its read-backs
// cost whatever they hold.
std::string model_of(const Shared& alone, const Shared& together) {
  const double whole = static_cast<double>(kQueries);
  const double fixed = (ms_a_query(alone) - ms_a_query(together)) * whole / (whole - 1);
  return text("%.3g ms a draw with its read-backs, %.3g ms a query", fixed,
              ms_a_query(alone) - fixed);
}

void method_rows(const Many& many, const std::string& what, GpuMethod method, Report& report) try {
  GpuZListOptions options;
  options.method = method;
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>();
  const auto stage = make_gpu_candidate_finder(options);
  const Many one{{}, {many.queries.front()}, {many.truth.front()}};
  Shared warm, first;  // the first query waits for the driver to compile the shaders
  ask_all(one, 1, *stage, warm);
  ask_all(one, 1, *stage, first);
  if (first.samples.median_ms() > kLongest_ms) return;
  constexpr size_t kTogether[] = {1, 4, 8, kQueries};
  Shared found[std::size(kTogether)];
  for (int round = 0; round < kPasses; ++round)  // in turn, so that all meet the same machine
    for (size_t i = 0; i < std::size(kTogether); ++i) ask_all(many, kTogether[i], *stage, found[i]);
  for (size_t i = 0; i < std::size(kTogether); ++i)
    report.add(
        {what + ", " + stage->name() + text(", %zu together", kTogether[i]), found[i].samples, 0, 0,
         text("%d queries in %lld draws, %lld read-backs; %.3g ms a query, %.2f of alone; %s",
              kQueries, static_cast<long long>(found[i].draws),
              static_cast<long long>(found[i].read_backs), ms_a_query(found[i]),
              ms_a_query(found[i]) / ms_a_query(found[0]),
              found[i].right ? "the same bits" : "WRONG")});
  report.remark(what + ", the model", model_of(found[0], found[std::size(kTogether) - 1]));
} catch (const Error& e) {
  report.remark(what, e.what());
}

}  // namespace

void together_rows(Report& report) {
  report.section("Queries that share a draw");
  for (const int num_triangles : {1'000, 15'000, 150'000}) {
    const SpherePair spheres = make_sphere_pair(num_triangles);
    for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation}) {
      const Many many = random_queries(spheres, kind);
      const std::string what = (kind == Motion::Kind::Translation ? "drop, " : "quarter turn, ") +
                               short_count(num_triangles);
      for (const auto method : {GpuMethod::Framebuffer, GpuMethod::Compute})
        method_rows(many, what, method, report);
    }
  }
}

}  // namespace trivet::perf
