#include "ops/arrange/solutions.h"

#include <algorithm>

#include "core/base/limits.h"

namespace trivet {
namespace {

constexpr int kSeedsPerSolution = 4;

}  // namespace

double difference_of(const Scene& a, const Scene& b, const std::vector<Thing>& things) {
  double sum = 0;
  for (const Thing& thing : things)
    sum += (a.at(*a.find(thing.object)).centre_of_mass() -
            b.at(*b.find(thing.object)).centre_of_mass())
               .norm();
  return things.empty() ? 0 : sum / double(things.size());
}

Solutions arrange_several(const Scene& scene, const Arrangement& arrangement,
                          const SolutionOptions& wanted, const SettleOptions& options,
                          const RunContext& context, const ArrangeProgress& progress) {
  Solutions out;
  const auto count = static_cast<size_t>(std::max(1, wanted.count));
  out.found.reserve(count);
  Arrangement trial = arrangement;
  const int most_seeds = count == 1 ? 1 : kSeedsPerSolution * static_cast<int>(count);
  // Seeds follow each other, so that solutions repeat; some give an arrangement that is known
  // already.
  for (; out.num_seeds < most_seeds && out.found.size() < count; ++out.num_seeds) {
    trial.seed = (arrangement.seed + static_cast<std::uint64_t>(out.num_seeds)) % (kMaxSeed + 1);
    Solution next{trial.seed, scene, {}, kInfinity};
    next.result = out.last = arrange(next.scene, trial, options, context, progress);
    const bool stopped = out.last.status == ArrangeResult::Status::Cancelled ||
                         out.last.status == ArrangeResult::Status::OutOfTime;
    // A first seed that ends in a conflict is the answer for all, as others hardly do better.
    if (stopped || (!out.last.ok() && out.num_seeds == 0)) {
      ++out.num_seeds;
      break;
    }
    if (!next.result.ok()) continue;
    // Solutions differ if things stand far enough from where any other one has them.
    for (const Solution& other : out.found)
      next.difference =
          std::min(next.difference, difference_of(next.scene, other.scene, arrangement.things));
    if (next.difference < wanted.least_difference)
      ++out.num_alike;
    else
      out.found.push_back(std::move(next));
  }
  return out;
}

}  // namespace trivet
