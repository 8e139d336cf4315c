#include "core/index/embree.h"

#include <string>

#include "core/base/error.h"

namespace trivet {

RTCDevice embree_device() {
  // Never released: at exit, Embree's and TBB's own statics may already be gone.
  static const RTCDevice device = [] {
    const RTCDevice made = rtcNewDevice(nullptr);
    if (!made)
      throw Error(Error::Kind::Environment,
                  "Embree cannot start (error %1); it needs a processor with SSE2 and memory",
                  static_cast<int>(rtcGetDeviceError(nullptr)));
    return made;
  }();
  return device;
}

void throw_embree_error(const char* what) {
  const RTCError error = rtcGetDeviceError(embree_device());
  if (error == RTC_ERROR_NONE) return;
  throw Error(Error::Kind::Environment, "Embree cannot %1 (error %2); it may lack memory", what,
              static_cast<int>(error));
}

}  // namespace trivet
