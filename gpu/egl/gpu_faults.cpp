#include "gpu/egl/gpu_faults.h"

#include "gpu/egl/environment_error.h"
#include "gpu/egl/gl_objects.h"

namespace trivet {

void GpuFaults::check_present() const {
  if (is_gone && is_gone()) throw environment_error("no OpenGL context: the device is gone");
}

void GpuFaults::check_no_reset() const {
  trivet::check_no_reset();
  if (resets && resets()) throw environment_error("the graphics hardware was reset, injected");
}

}  // namespace trivet
