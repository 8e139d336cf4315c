// Signals that ask a process to stop, as a descriptor.
#pragma once

#include <signal.h>

#include <chrono>

#include "core/io/process/local_sockets.h"

namespace trivet::farm {

/// Exit status of a process that was told to stop: run it again (sysexits.h).
inline constexpr int kComeAgain = 75;

/// From here on SIGTERM and SIGINT end the process with kComeAgain, but where StopSignals takes
/// them: for what comes before a batch, such as reading the bytes of its models.
void come_again_when_stopped();

/// Blocks SIGTERM and SIGINT, and takes them here; as before when it is destroyed. What began
/// before the first goes on for kSecondsToFinish, after the second for none. They may be nested:
/// one that nobody has read yet comes to the inner one.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  int descriptor() const { return m_descriptor.number(); }
  /// Reads what has come.
  void look();
  bool asked() const { return m_num > 0; }
  /// No more time to finish anything.
  bool at_once() const;

 private:
  static constexpr double kSecondsToFinish = 3;
  Descriptor m_descriptor;
  sigset_t m_before;
  int m_num = 0;
  std::chrono::steady_clock::time_point m_first;
};

}  // namespace trivet::farm
