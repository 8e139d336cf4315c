// Size of the long random tests.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace trivet::test {

/// `count` times TRIVET_TEST_EFFORT (default 1); tests/README.md says what sets it. The bands of
/// hit rates assume at least about a twentieth.
inline int with_effort(int count) {
  const char* text = std::getenv("TRIVET_TEST_EFFORT");
  const double factor = text ? std::atof(text) : 1.0;
  return factor > 0 ? std::max(1, static_cast<int>(count * factor)) : count;
}

}  // namespace trivet::test
