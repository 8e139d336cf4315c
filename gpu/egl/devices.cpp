#include "gpu/egl/devices.h"

#include <algorithm>

#include "gpu/egl/display.h"

namespace trivet {

std::vector<EglDevice> list_egl_devices() {
  std::vector<std::string> failures;
  std::vector<EglDevice> out;
  for (const EglCandidate& candidate : list_egl_candidates(failures))
    if (candidate.device > 0) out.push_back({candidate.device, candidate.software});
  std::sort(out.begin(), out.end(),
            [](const EglDevice& a, const EglDevice& b) { return a.number < b.number; });
  return out;
}

}  // namespace trivet
