// Order of tasks that the thread sanitizer cannot see: libraries of tasks are not compiled for it.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace trivet {

/// Tells the thread sanitizer that all before any give() is seen after a later take(), because a
/// library promises so. Does nothing else, and in other builds nothing.
class TaskOrder {
 public:
#ifdef __SANITIZE_THREAD__
  void give() { __tsan_release(&m_token); }
  void take() { __tsan_acquire(&m_token); }

 private:
  char m_token = 0;
#else
  void give() {}
  void take() {}
#endif
};

/// One callback of several that a library calls on threads of its own, each ordered with those
/// whose results it reads.
class OrderedStep {
 public:
  explicit OrderedStep(TaskOrder& order) : m_order(order) { m_order.take(); }
  ~OrderedStep() { m_order.give(); }
  OrderedStep(const OrderedStep&) = delete;
  OrderedStep& operator=(const OrderedStep&) = delete;

 private:
  TaskOrder& m_order;
};

}  // namespace trivet
