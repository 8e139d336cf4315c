// Cost of Embree's confirmation between software z-lists and the closed form, and the pairs that it
// leaves.
#include <tbb/global_control.h>

#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/sweeps.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::perf {
namespace {

constexpr int kConfirmSweeps = 12;
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

/// Of all sweeps of a size and kind of motion; CPU ms.
struct Stages {
  Samples zlists, whole;
  std::vector<double> confirm_ms, exact_ms, exact_alone_ms, proposed, asked, confirmed, share;
  int num_different = 0;
  ResultHash hash;
};

bool same_contact(const FirstContact& a, const FirstContact& b) {
  return a.status == b.status && a.time == b.time && a.face_moving == b.face_moving &&
         a.face_fixed == b.face_fixed && a.point == b.point && a.normal == b.normal;
}

void ask(const FirstContactQuery& query, Stages& out) {
  SoftwareZLists zlists;
  CandidatePairs proposal, kept;
  const Took drawn =
      timed_warm([&] { proposal = zlists.find_candidates(query, query.motion.limit); });
  out.zlists.add(drawn);
  out.whole.add(timed_warm([&] { first_contact(query, zlists); }));
  Replay all(proposal);
  FirstContact with, without;
  const double both = timed_warm([&] { with = first_contact(query, all, &kept); }).cpu_ms;
  Replay confirmed(kept);
  const double after = timed_warm([&] { first_contact(query, confirmed, nullptr, kNone); }).cpu_ms;
  const double alone =
      timed_warm([&] { without = first_contact(query, all, nullptr, kNone); }).cpu_ms;
  const double confirm = kept.work.asked_pairs > 0 ? std::max(0.0, both - after) : 0;
  out.confirm_ms.push_back(confirm);
  out.exact_ms.push_back(after);
  out.exact_alone_ms.push_back(alone);
  out.proposed.push_back(static_cast<double>(kept.work.face_pairs));
  out.asked.push_back(static_cast<double>(kept.work.asked_pairs));
  out.confirmed.push_back(static_cast<double>(kept.work.confirmed_pairs));
  out.share.push_back(100 * confirm / drawn.cpu_ms);
  out.num_different += !same_contact(with, without);
  out.hash.add(with);
}

Stages ask_all(const SpherePair& spheres, Motion::Kind kind) {
  Stages out;
  test::Random random(23);
  for (int i = 0; i < kConfirmSweeps; ++i) {
    const Sweep sweep = kind == Motion::Kind::Translation ? random_drop(spheres, random)
                                                          : random_turn(spheres, random);
    const Body moving = sweep.moving(), fixed = sweep.fixed();
    ask({{&moving, 1}, {&fixed, 1}, false, sweep.motion, sweep.clearance}, out);
  }
  return out;
}

void rows_of(const SpherePair& spheres, Motion::Kind kind, Report& report) {
  const bool drop = kind == Motion::Kind::Translation;
  const std::string size = short_count(spheres.num_triangles);
  report.section("Embree confirms: " + size + " triangles against " + size + ", " +
                 (drop ? "drop" : "quarter turn"));
  const Stages s = ask_all(spheres, kind);
  report.add({"z-lists in software", s.zlists, 0, 0,
              text("median %.0f pairs proposed", median(s.proposed))});
  report.remark("Embree confirms",
                text("median %.3f CPU ms, %.1f %% of the z-lists (at most %.1f); asked about %.0f "
                     "pairs, confirms %.0f",
                     median(s.confirm_ms), median(s.share), quantile(s.share, 1), median(s.asked),
                     median(s.confirmed)));
  report.remark("closed form", text("median %.3f CPU ms, without confirmation %.3f",
                                    median(s.exact_ms), median(s.exact_alone_ms)));
  report.add({"the whole query", s.whole, 0, 0,
              s.num_different == 0 ? "the same bits with and without confirmation"
                                   : text("WRONG %d", s.num_different)});
  report.add_hash(s.hash.value());
}

}  // namespace

void confirm_rows(Report& report) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  for (const int num_triangles : {1'000, 15'000, 150'000, 1'500'000}) {
    const SpherePair spheres = make_sphere_pair(num_triangles);
    for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation})
      rows_of(spheres, kind, report);
  }
}

}  // namespace trivet::perf
