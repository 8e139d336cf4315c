// EGL devices as the drivers list them.
#pragma once

#include <vector>

namespace trivet {

struct EglDevice {
  int number = 0;         // from 1, as in "EGL device 1 of 2"
  bool software = false;  // as reported by the driver
};

/// In the order of their numbers. Loads EGL and its drivers; starts none.
/// @throws Error (Environment) when libEGL or libGL is not installed.
std::vector<EglDevice> list_egl_devices();

}  // namespace trivet
