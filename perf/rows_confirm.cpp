// Stages of a query by each finder of candidates: depths, lists, Embree's confirmation and the
// closed form, and the pairs that are left.
#include <tbb/global_control.h>

#include "core/base/error.h"
#include "perf/gpu_stages.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/sweeps.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::perf {
namespace {

constexpr int kStageSweeps = 12;
constexpr double kFinderBudget_ms = 8000;  // CPU, then other sweeps are skipped
constexpr size_t kFewestStageSweeps = 3;
constexpr Confirmation kNone{false, 0};

/// Says again what another stage said.
class Replay : public CandidateFinder {
 public:
  explicit Replay(CandidatePairs said) : m_said(std::move(said)) {}
  std::string name() const override { return "replay"; }
  CandidatePairs find_candidates(const FirstContactQuery& /*query*/, double /*horizon*/) override {
    return m_said;
  }

 private:
  CandidatePairs m_said;
};

struct AnsweredSweep {
  Sweep sweep;
  FirstContact truth;
};

/// By one finder, of all sweeps of a size and kind of motion; CPU ms of all threads.
struct Stages {
  Samples whole;
  std::vector<double> depth_ms, list_ms, confirm_ms, exact_ms, exact_alone_ms;
  std::vector<double> proposed, asked, confirmed, share;
  int num_given_up = 0, num_wrong = 0;
};

bool same_contact(const FirstContact& a, const FirstContact& b) {
  return a.status == b.status && a.time == b.time && a.face_moving == b.face_moving &&
         a.face_fixed == b.face_fixed && a.point == b.point && a.normal == b.normal;
}

/// Of all threads: drivers have their own.
template <class Work>
Took timed_all(Work&& work) {
  return timed_warm(std::forward<Work>(work), CLOCK_PROCESS_CPUTIME_ID);
}

/// Embree and the closed form, from a proposal that costs nothing.
void decide(const FirstContactQuery& query, const FirstContact& truth,
            const CandidatePairs& proposal, double drawn_ms, Stages& out) {
  Replay all(proposal);
  CandidatePairs kept;
  FirstContact with, without;
  const double both = timed_all([&] { with = first_contact(query, all, &kept); }).cpu_ms;
  Replay confirmed(kept);
  const double after = timed_all([&] { first_contact(query, confirmed, nullptr, kNone); }).cpu_ms;
  const double alone =
      timed_all([&] { without = first_contact(query, all, nullptr, kNone); }).cpu_ms;
  const double confirm = kept.work.asked_pairs > 0 ? std::max(0.0, both - after) : 0;
  out.confirm_ms.push_back(confirm);
  out.exact_ms.push_back(after);
  out.exact_alone_ms.push_back(alone);
  out.proposed.push_back(static_cast<double>(kept.work.face_pairs));
  out.asked.push_back(static_cast<double>(kept.work.asked_pairs));
  out.confirmed.push_back(static_cast<double>(kept.work.confirmed_pairs));
  out.share.push_back(100 * confirm / drawn_ms);
  out.num_wrong += !same_contact(with, truth) || !same_contact(without, truth);
}

void ask(const FirstContactQuery& query, const FirstContact& truth, const StagedFinder& finder,
         Stages& out) {
  const double limit = query.motion.limit;
  CandidatePairs proposal;
  FirstContact found;
  const double drawn =
      timed_all([&] { proposal = finder.whole->find_candidates(query, limit); }).cpu_ms;
  double depth = 0;
  if (finder.depths)
    depth = timed_all([&] { finder.depths->find_candidates(query, limit); }).cpu_ms;
  out.whole.add(timed_all([&] { found = first_contact(query, *finder.whole); }));
  out.num_wrong += !same_contact(found, truth);
  out.depth_ms.push_back(depth);
  out.list_ms.push_back(std::max(0.0, drawn - depth));
  if (proposal.usable)
    decide(query, truth, proposal, drawn, out);
  else
    ++out.num_given_up;
}

Stages ask_all(const std::vector<AnsweredSweep>& sweeps, const StagedFinder& finder) {
  Stages out;
  const Stopwatch stopwatch(CLOCK_PROCESS_CPUTIME_ID);
  for (const AnsweredSweep& a : sweeps) {
    const bool enough = out.whole.count() >= kFewestStageSweeps;
    if (enough && stopwatch.elapsed().cpu_ms > kFinderBudget_ms) break;
    const Body moving = a.sweep.moving(), fixed = a.sweep.fixed();
    const FirstContactQuery query{
        {&moving, 1}, {&fixed, 1}, false, a.sweep.motion, a.sweep.clearance};
    // Meshes get into graphics memory.
    if (&a == sweeps.data()) finder.whole->find_candidates(query, query.motion.limit);
    if (&a == sweeps.data() && finder.depths)
      finder.depths->find_candidates(query, query.motion.limit);
    ask(query, a.truth, finder, out);
  }
  return out;
}

std::string outcome_of(const Stages& s) {
  std::string out = text(
      "depths %.3g, lists %.3g, Embree %.3g (%.1f %% of both, at most %.1f), closed form %.3g "
      "(without Embree %.3g); pairs: %.0f proposed, %.0f asked about, %.0f confirmed",
      median(s.depth_ms), median(s.list_ms), median(s.confirm_ms), median(s.share),
      quantile(s.share, 1), median(s.exact_ms), median(s.exact_alone_ms), median(s.proposed),
      median(s.asked), median(s.confirmed));
  if (s.num_given_up > 0) out += text("; gave up %d", s.num_given_up);
  return out + (s.num_wrong ? text("; WRONG %d", s.num_wrong) : "; the same bits");
}

/// BVHs answer first, and are what the others are compared with.
std::vector<AnsweredSweep> ask_bvhs(const SpherePair& spheres, Motion::Kind kind, Report& report) {
  std::vector<AnsweredSweep> out;
  Row row{"BVHs, the whole query", {}, 0, 0, ""};
  std::vector<double> pairs;
  test::Random random(23);
  ResultHash hash;
  for (int i = 0; i < kStageSweeps; ++i) {
    AnsweredSweep a{kind == Motion::Kind::Translation ? random_drop(spheres, random)
                                                      : random_turn(spheres, random),
                    {}};
    row.samples.add(timed_all([&] { a.truth = a.sweep.first_contact(); }));
    pairs.push_back(static_cast<double>(a.truth.work.face_pairs));
    hash.add(a.truth);
    out.push_back(a);
  }
  row.outcome = text("median %.0f pairs decided", median(pairs));
  report.add(std::move(row));
  report.add_hash(hash.value());
  return out;
}

void rows_of(const SpherePair& spheres, Motion::Kind kind, std::vector<StagedFinder>& finders,
             Report& report) {
  const bool drop = kind == Motion::Kind::Translation;
  const std::string size = short_count(spheres.num_triangles);
  report.section("Stages, median CPU ms of all threads: " + size + " triangles against " + size +
                 ", " + (drop ? "drop" : "quarter turn"));
  const std::vector<AnsweredSweep> sweeps = ask_bvhs(spheres, kind, report);
  for (const StagedFinder& finder : finders) {
    const Stages s = ask_all(sweeps, finder);
    report.add({finder.name, s.whole, 0, 0, outcome_of(s)});
  }
}

std::vector<StagedFinder> finders(Report& report) {
  std::vector<StagedFinder> out;
  out.push_back({"z-lists in software, one thread", std::make_unique<SoftwareZLists>(), nullptr});
  try {
    for (StagedFinder& finder : staged_gpu_finders()) out.push_back(std::move(finder));
  } catch (const Error& error) {
    report.remark("z-lists on the GPU", error.what());
  }
  return out;
}

}  // namespace

void confirm_rows(Report& report) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  std::vector<StagedFinder> all = finders(report);
  for (const int num_triangles : {1'000, 15'000, 150'000, 1'500'000}) {
    const SpherePair spheres = make_sphere_pair(num_triangles);
    for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation})
      rows_of(spheres, kind, all, report);
  }
}

}  // namespace trivet::perf
