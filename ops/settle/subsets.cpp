#include "ops/settle/subsets.h"

#include <algorithm>

namespace trivet {

std::vector<ContactPoint> points_without(const std::vector<TouchedPoint>& all,
                                         const std::vector<Index>& left_out) {
  std::vector<ContactPoint> out;
  for (const TouchedPoint& t : all)
    if (!std::binary_search(left_out.begin(), left_out.end(), t.fixed)) out.push_back(t.point);
  return out;
}

bool holds_without_some(const std::vector<Index>& bodies,
                        const std::function<Hold(const std::vector<Index>& left_out)>& hold) {
  std::vector<std::vector<Index>> level{{}}, never;
  int num_asked = 0;
  // Each level leaves out one body more than the one before.
  while (!level.empty()) {
    std::vector<std::vector<Index>> next;
    for (const std::vector<Index>& fewer : level)
      for (const Index body : bodies) {
        if (!fewer.empty() && body <= fewer.back()) continue;  // each subset comes once
        std::vector<Index> left_out = fewer;
        left_out.push_back(body);
        // A set that contains one which can never hold needs no question.
        const bool in_vain = std::any_of(never.begin(), never.end(), [&](const auto& n) {
          return std::includes(left_out.begin(), left_out.end(), n.begin(), n.end());
        });
        if (in_vain) continue;
        // The number of questions is bounded, as subsets grow exponentially.
        if (num_asked++ == kMaxSubsets) return false;
        const Hold found = hold(left_out);
        if (found == Hold::Yes) return true;
        (found == Hold::Never ? never : next).push_back(std::move(left_out));
      }
    level = std::move(next);
  }
  return false;
}

}  // namespace trivet
