// A value that is made when it is first asked for.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>

namespace trivet {

/// Made once, by whichever thread asks first; others wait for it. Thread-safe.
template <class T>
class Lazy {
 public:
  /// @param make  returns the value. If it throws, the next caller tries again. It must not take up
  ///   tasks of others, which may ask for this value, too.
  template <class Make>
  const T& get(const Make& make) {
    if (const T* made = m_made.load(std::memory_order_acquire)) return *made;
    const std::lock_guard lock(m_mutex);
    if (!m_value) m_made.store(&m_value.emplace(make()), std::memory_order_release);
    return *m_value;
  }
  bool is_made() const { return m_made.load(std::memory_order_acquire) != nullptr; }

 private:
  std::atomic<const T*> m_made = nullptr;
  std::mutex m_mutex;
  std::optional<T> m_value;
};

}  // namespace trivet
