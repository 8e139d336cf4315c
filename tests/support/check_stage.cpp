#include "support/check_stage.h"

#include <algorithm>
#include <sstream>
#include <tuple>

namespace trivet::test {
namespace {

constexpr size_t kMostTexts = 5;

auto key(const FacePair& p) {
  return std::tie(p.not_before, p.moving, p.fixed, p.face_moving, p.face_fixed);
}

std::string wrong_order(const CandidatePairs& proposal) {
  const auto before = [](const FacePair& a, const FacePair& b) { return key(a) < key(b); };
  if (!std::is_sorted(proposal.pairs.begin(), proposal.pairs.end(), before)) return "unsorted";
  std::vector<std::array<Index, 4>> pairs;
  for (const FacePair& p : proposal.pairs)
    pairs.push_back({p.moving, p.fixed, p.face_moving, p.face_fixed});
  std::sort(pairs.begin(), pairs.end());
  if (std::adjacent_find(pairs.begin(), pairs.end()) != pairs.end()) return "a pair twice";
  return "";
}

// Compares bounds with the truth; stages do not know the floor.
std::string wrong_bounds(const CandidatePairs& proposal, const FirstContact& truth) {
  const bool touches = truth.status != FirstContact::Status::Free;
  const double time = touches ? truth.time : kInfinity;
  if (proposal.upper < time) return "upper bound too early";
  if (proposal.lower > proposal.upper) return "bounds crossed";
  if (!touches || truth.fixed == FirstContact::kFloor) return "";
  if (proposal.lower > time) return "lower bound too late";
  for (const FacePair& p : proposal.pairs)
    if (p.moving == truth.moving && p.fixed == truth.fixed && p.face_moving == truth.face_moving &&
        p.face_fixed == truth.face_fixed)
      return p.not_before > time ? "a pair's bound is too late" : "";
  return "the first pair is not proposed";
}

std::int64_t num_faces(const std::vector<PosedShape>& bodies) {
  std::int64_t out = 0;
  for (const PosedShape& b : bodies) out += b.shape->mesh.triangles.size();
  return out;
}

void check(const RandomQuery& q, CandidateFinder& stage, StageCheck& out) {
  CandidatePairs proposal;
  const FirstContact found = q.with_stage(stage, &proposal), truth = q.fast();
  out.num_contacts += truth.status == FirstContact::Status::Contact;
  out.num_crossings += truth.status == FirstContact::Status::Crossing;
  std::string what;
  if (!same_answer(truth, q.brute_force())) what = "BVHs differ from brute force";
  if (!same_answer(found, truth)) what = "another answer: " + test::describe(found);
  if (proposal.usable) {
    if (what.empty()) what = wrong_bounds(proposal, truth);
    if (what.empty()) what = wrong_order(proposal);
    out.num_upper += proposal.upper < kInfinity;
    out.num_pairs += static_cast<std::int64_t>(proposal.pairs.size());
    out.num_all_pairs += num_faces(q.moving) * num_faces(q.fixed);
  } else {
    ++out.num_unusable;
    if (out.reasons.size() < kMostTexts) out.reasons.push_back(proposal.why);
  }
  if (!what.empty() && out.failures.size() < kMostTexts)
    out.failures.push_back(what + "\nBVHs: " + test::describe(truth) + "\n" + q.describe());
}

}  // namespace

std::string StageCheck::describe() const {
  std::ostringstream out;
  out << num << " queries, " << num_contacts << " contacts, " << num_crossings
      << " crossings, upper bounds of " << num_upper << ", " << num_unusable << " unusable, "
      << num_pairs << " of " << num_all_pairs << " pairs proposed";
  for (const std::string& text : reasons) out << "\nunusable: " << text;
  for (const std::string& text : failures) out << "\n" << text;
  return out.str();
}

StageCheck check_stage(CandidateFinder& stage, const MeshPool& pool, unsigned seed, int first,
                       int num) {
  StageCheck out;
  out.num = num;
  for (int i = 0; i < num; ++i)
    check(i < num - num / 4 ? random_query(pool, seed, first + i)
                            : random_group_query(pool, seed, first + i),
          stage, out);
  return out;
}

}  // namespace trivet::test
