// Stages of a query by each finder of candidates: depths alone, depths and lists, Embree's
// confirmation and the closed form, and the pairs that are left. Each is timed by itself.
#include <tbb/global_control.h>

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/candidates/confirm.h"
#include "core/candidates/zlist_frame.h"
#include "perf/gpu_stages.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/sweeps.h"
#include "raster/zlist/motion_depths.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::perf {
namespace {

constexpr int kStageSweeps = 12;
// Drivers that draw on the processor take seconds a sweep of large meshes. A finder of one size and
// kind of motion asks no further sweep after this time, so that all rows take a minute or two.
constexpr double kFinderBudget_ms = 2000;  // CPU
constexpr Confirmation kNone = kConfirmNone;

/// Depths of all faces in software, as a GPU draws them: no candidates.
class SoftwareDepths : public CandidateFinder {
 public:
  std::string name() const override { return "software, depths"; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    const MotionDepths depths =
        motion_depths(query, horizon, zlist_resolution_of_processors(query));
    CandidatePairs out;
    out.lower = depths.lower, out.upper = depths.upper;
    return out;
  }
};

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
  std::vector<double> depth_ms, drawn_ms;  // alone; with lists
  // Embree is forced on all pairs of every proposal. Then the closed form, and the same without it.
  std::vector<double> confirm_ms, exact_ms, exact_alone_ms;
  std::vector<double> proposed, confirmed;
  std::vector<double> share, share_by_rule;  // % of depths and lists; 0 where the rule asks not
  int num_asked_by_rule = 0, num_too_many = 0, num_given_up = 0, num_wrong = 0;
};

bool same_contact(const FirstContact& a, const FirstContact& b) {
  return a.status == b.status && a.time == b.time && a.face_moving == b.face_moving &&
         a.face_fixed == b.face_fixed && a.point == b.point && a.normal == b.normal;
}

/// Counts all threads: drivers have their own.
template <class Work>
Took timed_all(Work&& work) {
  return timed_warm(std::forward<Work>(work), CLOCK_PROCESS_CPUTIME_ID);
}

/// A question for Embree: faces, and up to when.
struct Question {
  std::vector<FacePair> pairs;
  double horizon;

  /// @return CPU ms.
  double ask(const FirstContactQuery& query, std::vector<FacePair>& kept, bool& answered) const {
    return timed_all([&] {
             kept = pairs;
             FirstContact best;
             answered = decide_by_embree(query, horizon, kept, best);
           })
        .cpu_ms;
  }
};

/// As first_contact() asks: about what is left when the first pairs are decided, if it is much.
std::optional<Question> question_by_rule(const FirstContactQuery& query,
                                         const CandidatePairs& proposal) {
  const size_t num_first = std::min(kPairsBeforeEmbree, proposal.pairs.size());
  const auto begin = proposal.pairs.begin() + static_cast<std::ptrdiff_t>(num_first);
  CandidatePairs first;
  first.usable = true;
  first.pairs.assign(proposal.pairs.begin(), begin);
  Replay replay(std::move(first));
  const double horizon =
      std::min(first_contact(query, replay, nullptr, kNone).time, query.motion.limit);
  const auto end = std::partition_point(begin, proposal.pairs.end(),
                                        [&](const FacePair& p) { return p.not_before <= horizon; });
  if (static_cast<size_t>(end - begin) < kFewestForEmbree) return std::nullopt;
  return Question{{begin, end}, std::min(horizon, proposal.upper)};
}

/// Embree and the closed form, from a proposal that costs nothing.
void decide(const FirstContactQuery& query, const FirstContact& truth,
            const CandidatePairs& proposal, double drawn_ms, Stages& out) {
  bool answered = true;
  CandidatePairs kept = proposal;
  const Question forced{proposal.pairs, std::min(query.motion.limit, proposal.upper)};
  out.confirm_ms.push_back(forced.ask(query, kept.pairs, answered));
  out.num_too_many += !answered;
  out.share.push_back(100 * out.confirm_ms.back() / drawn_ms);
  out.proposed.push_back(static_cast<double>(proposal.pairs.size()));
  out.confirmed.push_back(static_cast<double>(kept.pairs.size()));
  const std::optional<Question> by_rule = question_by_rule(query, proposal);
  std::vector<FacePair> left;
  const double by_rule_ms = by_rule ? by_rule->ask(query, left, answered) : 0;
  out.share_by_rule.push_back(100 * by_rule_ms / drawn_ms);
  out.num_asked_by_rule += by_rule.has_value();
  Replay confirmed(kept), all(proposal);
  FirstContact with, without;
  out.exact_ms.push_back(
      timed_all([&] { with = first_contact(query, confirmed, nullptr, kNone); }).cpu_ms);
  out.exact_alone_ms.push_back(
      timed_all([&] { without = first_contact(query, all, nullptr, kNone); }).cpu_ms);
  out.num_wrong += !same_contact(with, truth) || !same_contact(without, truth);
}

void ask(const FirstContactQuery& query, const FirstContact& truth, const StagedFinder& finder,
         Stages& out) {
  const double limit = query.motion.limit;
  CandidatePairs proposal;
  FirstContact found;
  const double drawn =
      timed_all([&] { proposal = finder.whole->find_candidates(query, limit); }).cpu_ms;
  out.depth_ms.push_back(timed_all([&] { finder.depths->find_candidates(query, limit); }).cpu_ms);
  out.whole.add(timed_all([&] { found = first_contact(query, *finder.whole); }));
  out.num_wrong += !same_contact(found, truth);
  out.drawn_ms.push_back(drawn);
  if (proposal.usable)
    decide(query, truth, proposal, drawn, out);
  else
    ++out.num_given_up;
}

Stages ask_all(const std::vector<AnsweredSweep>& sweeps, const StagedFinder& finder) {
  Stages out;
  const Stopwatch stopwatch(CLOCK_PROCESS_CPUTIME_ID);
  for (const AnsweredSweep& a : sweeps) {
    if (out.whole.count() > 0 && stopwatch.elapsed().cpu_ms > kFinderBudget_ms) break;
    const Body moving = a.sweep.moving(), fixed = a.sweep.fixed();
    const FirstContactQuery query{
        {&moving, 1}, {&fixed, 1}, false, a.sweep.motion, a.sweep.clearance};
    // Meshes get into graphics memory.
    if (&a == sweeps.data()) finder.whole->find_candidates(query, query.motion.limit);
    if (&a == sweeps.data()) finder.depths->find_candidates(query, query.motion.limit);
    ask(query, a.truth, finder, out);
  }
  return out;
}

std::string outcome_of(const Stages& s) {
  std::string out =
      text("depths %.3g, depths and lists %.3g", median(s.depth_ms), median(s.drawn_ms));
  out += text("; pairs: %.0f proposed, %.0f confirmed", median(s.proposed), median(s.confirmed));
  out += text("; Embree on all %.3g (%.1f %% of depths and lists, at most %.1f)",
              median(s.confirm_ms), median(s.share), quantile(s.share, 1));
  if (s.num_too_many > 0) out += text(", too many for it in %d", s.num_too_many);
  out += text(", by the rule in %d of %zu (%.1f %%, at most %.1f)", s.num_asked_by_rule,
              s.share.size(), median(s.share_by_rule), quantile(s.share_by_rule, 1));
  out +=
      text("; closed form %.3g, without Embree %.3g", median(s.exact_ms), median(s.exact_alone_ms));
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
  out.push_back({"z-lists in software, one thread", std::make_unique<SoftwareZLists>(),
                 std::make_unique<SoftwareDepths>()});
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
