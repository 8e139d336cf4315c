// Random and degenerate motions by every source of candidates, with and without Embree's
// confirmation: the bits of brute force. TRIVET_TEST_EFFORT=500 makes 100,000 of them.
#include <gtest/gtest.h>

#include <iostream>
#include <sstream>

#include "core/candidates/confirm.h"
#include "gpu/zlist/ways.h"
#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

constexpr unsigned kCampaignSeed = 777;
constexpr int kReportEvery = 1000;
constexpr Confirmation kAskNothing = kConfirmNone;

/// Gives every proposal of another stage twice: as it is, then less the pairs that Embree does not
/// confirm, of all, however few.
class Twice : public CandidateFinder {
 public:
  explicit Twice(std::unique_ptr<CandidateFinder> stage) : m_stage(std::move(stage)) {}
  std::string name() const override { return m_stage->name(); }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    m_is_second = !m_is_second;
    if (m_is_second) return m_last = m_stage->find_candidates(query, horizon);
    CandidatePairs& p = m_last;
    if (!p.usable || p.pairs.empty()) return p;
    std::vector<FacePair> pairs = p.pairs;
    FirstContact best;
    if (!decide_by_embree(query, std::min(horizon, p.upper), pairs, best)) return p;
    ++num_asked;
    asked += static_cast<std::int64_t>(p.pairs.size());
    confirmed += static_cast<std::int64_t>(pairs.size());
    p.pairs = std::move(pairs);
    return p;
  }

  int num_asked = 0;
  std::int64_t asked = 0, confirmed = 0;

 private:
  std::unique_ptr<CandidateFinder> m_stage;
  CandidatePairs m_last;
  bool m_is_second = false;
};

/// A source at one resolution, and what became of its answers.
struct Source {
  std::string name;
  std::unique_ptr<Twice> stage;
  int num = 0, num_wrong = 0, num_unusable = 0;

  void check(const FirstContactQuery& query, const FirstContact& truth,
             const test::RandomQuery& q) {
    CandidatePairs proposal;
    const FirstContact without = first_contact(query, *stage, &proposal, kAskNothing);
    const FirstContact with = first_contact(query, *stage, nullptr, kAskNothing);
    ++num;
    num_unusable += !proposal.usable;
    if (test::same_answer(with, truth) && test::same_answer(without, truth)) return;
    ++num_wrong;
    ADD_FAILURE() << name << "\nwith confirmation: " << test::describe(with)
                  << "\nwithout: " << test::describe(without)
                  << "\nbrute force: " << test::describe(truth) << "\n"
                  << q.describe();
  }

  std::string describe() const {
    std::ostringstream out;
    out << name << ": " << num << " motions, " << num_wrong << " wrong, " << num_unusable
        << " left to BVHs, Embree asked in " << stage->num_asked << ", confirmed "
        << stage->confirmed << " of " << stage->asked << " pairs\n";
    return out.str();
  }
};

Source source(const std::string& name, int resolution, std::unique_ptr<CandidateFinder> stage) {
  Source out;
  out.name = name + " at " + std::to_string(resolution);
  if (stage) out.stage = std::make_unique<Twice>(std::move(stage));
  return out;
}

/// Empty without EGL.
std::vector<Source> sources_at(int resolution) {
  std::vector<Source> out;
  SoftwareZListOptions software;
  software.resolution = resolution;
  out.push_back(source("software", resolution, std::make_unique<SoftwareZLists>(software)));
  for (const auto& [name, way] :
       {std::pair("framebuffer", test::kFramebufferWay), std::pair("compute", test::kComputeWay),
        std::pair("hybrid", test::kHybridWay)}) {
    out.push_back(
        source(name, resolution, test::make_stage(way.options({.resolution = resolution}))));
    if (!out.back().stage) return {};
  }
  return out;
}

/// Rotations and translations, groups over a floor, starts in contact, needles and faces without
/// area; see random_query().
test::RandomQuery motion(const test::MeshPool& pool, int i) {
  return i % 4 ? test::random_query(pool, kCampaignSeed, i)
               : test::random_group_query(pool, kCampaignSeed, i);
}

TEST(ZListCampaign, EqualsBruteForceByEverySource) {
  std::vector<Source> coarse = sources_at(16), fine = sources_at(64);
  if (coarse.empty()) GTEST_SKIP() << "this machine has no OpenGL through EGL";
  const test::MeshPool pool(kCampaignSeed, 8);
  const int num = test::with_effort(200);
  int num_contacts = 0, num_wrong = 0;
  const auto print = [&](int done) {
    std::cout << "seed " << kCampaignSeed << ", " << done << " motions, " << num_contacts
              << " contacts; BVHs wrong " << num_wrong << "\n";
    for (const auto* sources : {&coarse, &fine})
      for (const Source& s : *sources) std::cout << "  " << s.describe();
    std::cout << std::flush;
  };
  for (int i = 0; i < num; ++i) {
    const test::RandomQuery q = motion(pool, i);
    q.ask([&](const FirstContactQuery& query) {
      const FirstContact truth = first_contact_brute_force(query);
      num_contacts += truth.status == FirstContact::Status::Contact;
      const bool same = test::same_answer(first_contact(query), truth);
      num_wrong += !same;
      EXPECT_TRUE(same) << q.describe();
      for (Source& s : i % 8 ? coarse : fine) s.check(query, truth, q);
    });
    if ((i + 1) % kReportEvery == 0) print(i + 1);
  }
  print(num);
  EXPECT_GT(num_contacts, num / 5);
  for (const Source& s : coarse) {
    EXPECT_GT(s.stage->num_asked, num / 4) << s.describe();
    EXPECT_LT(s.stage->confirmed, s.stage->asked) << s.describe();
  }
}

}  // namespace
}  // namespace trivet
