#include "ops/detect/detector_pool.h"

#include <unistd.h>

namespace trivet {

DetectorPool::DetectorPool(Make make) : m_make(std::move(make)), m_process(getpid()) {}

DetectorPool::~DetectorPool() { leave_those_of_parent(); }

// Their drivers' threads are not here: whatever ended them could wait for ever.
void DetectorPool::leave_those_of_parent() {
  // After a fork the child owns copies that it must not end.
  if (m_process == getpid()) return;
  for (std::unique_ptr<Detector>& detector : m_free) static_cast<void>(detector.release());
  m_free.clear();
  m_process = getpid();
}

std::unique_ptr<Detector> DetectorPool::take() {
  // The lock is given back before a new one is made, which may take a while.
  {
    const std::lock_guard lock(m_mutex);
    leave_those_of_parent();
    if (!m_free.empty()) {
      std::unique_ptr<Detector> out = std::move(m_free.back());
      m_free.pop_back();
      return out;
    }
  }
  return m_make ? m_make() : nullptr;
}

DetectorPool::Loan::Loan(DetectorPool& from)
    : m_from(from), m_detector(from.take()), m_process(getpid()) {}

DetectorPool::Loan::~Loan() {
  if (m_process == getpid())
    m_from.give_back(std::move(m_detector));
  else
    static_cast<void>(m_detector.release());
}

void DetectorPool::give_back(std::unique_ptr<Detector> detector) {
  if (!detector) return;
  const std::lock_guard lock(m_mutex);
  m_free.push_back(std::move(detector));
}

}  // namespace trivet
