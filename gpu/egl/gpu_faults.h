// Faults that tests inject into what uses a GPU.
#pragma once

#include <functional>

namespace trivet {

struct GpuFaults {
  std::function<bool()> resets = {};   // asked after every query; true: the hardware was reset
  std::function<bool()> is_gone = {};  // asked before a context is made; true: no device is there

  /// @throws Error (Environment) if the device is gone, before a context is made.
  void check_present() const;
  /// Reports a reset of the current context's hardware, by the driver or injected.
  /// @throws Error (Environment)
  void check_no_reset() const;
};

}  // namespace trivet
