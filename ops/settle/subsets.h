// Subsets of contacts: an object also rests when some of its contacts would hold it alone, so that
// a further contact never takes rest away.
#pragma once

#include <functional>
#include <vector>

#include "core/contact/contact.h"

namespace trivet {

/// A contact point and the number of its partner.
struct TouchedPoint {
  Index fixed;
  ContactPoint point;
};

/// Points on other bodies than these (sorted).
std::vector<ContactPoint> points_without(const std::vector<TouchedPoint>& all,
                                         const std::vector<Index>& left_out);

/// The judgement of what is left when some bodies are left out.
enum class Hold {
  Yes,
  No,     // less of it may hold
  Never,  // nor does less of it: no forces balance
};

/// Subsets that are asked at most: all of up to 6 bodies.
inline constexpr int kMaxSubsets = 64;

/// True if what is left holds when one or more of `bodies` (sorted, each once) are left out. Fewer
/// are left out first; the order is that of the indices.
bool holds_without_some(const std::vector<Index>& bodies,
                        const std::function<Hold(const std::vector<Index>& left_out)>& hold);

}  // namespace trivet
