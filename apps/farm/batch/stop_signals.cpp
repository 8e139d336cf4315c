#include "apps/farm/batch/stop_signals.h"

#include <sys/signalfd.h>
#include <unistd.h>

namespace trivet::farm {

void come_again_when_stopped() {
  struct sigaction action {};
  action.sa_handler = [](int) { _exit(kComeAgain); };
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
}

StopSignals::StopSignals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGINT);
  sigprocmask(SIG_BLOCK, &set, &m_before);
  m_descriptor = Descriptor(signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK));
}

StopSignals::~StopSignals() {
  look();  // what came twice is not delivered again
  sigprocmask(SIG_SETMASK, &m_before, nullptr);
}

void StopSignals::look() {
  signalfd_siginfo info;
  while (read(m_descriptor.number(), &info, sizeof info) == static_cast<ssize_t>(sizeof info))
    if (m_num++ == 0) m_first = std::chrono::steady_clock::now();
}

bool StopSignals::at_once() const {
  if (m_num == 0) return false;
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - m_first;
  return m_num > 1 || since.count() > kSecondsToFinish;
}

}  // namespace trivet::farm
