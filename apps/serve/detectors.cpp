#include "apps/serve/detectors.h"

namespace trivet::serve {

std::unique_ptr<Detector> Detectors::take() {
  {
    const std::lock_guard lock(m_mutex);
    if (!m_free.empty()) {
      std::unique_ptr<Detector> out = std::move(m_free.back());
      m_free.pop_back();
      return out;
    }
  }
  return m_make ? m_make() : nullptr;
}

void Detectors::give_back(std::unique_ptr<Detector> detector) {
  if (!detector) return;
  const std::lock_guard lock(m_mutex);
  m_free.push_back(std::move(detector));
}

}  // namespace trivet::serve
