// Private to gpu: the machine's EGL displays that support drawing without a window.
#pragma once

#include <epoxy/egl.h>

#include <string>
#include <vector>

namespace trivet {

/// A possible renderer, not yet initialised.
struct EglCandidate {
  std::string name;  // "EGL device 1 of 2"
  int device = 0;    // the first of these numbers; 0: none
  EGLDisplay display = EGL_NO_DISPLAY;
  bool software = false;  // as reported by the driver (EGL_MESA_device_software)
};

/// Devices, hardware first, then the surfaceless platform. Failed enumerations are added to
/// `failures`.
/// @throws Error (Environment) when libEGL or libGL is not installed.
std::vector<EglCandidate> list_egl_candidates(std::vector<std::string>& failures);

/// An initialised display. EGL keeps one state per display and process, which a single eglTerminate
/// would destroy for every user, so initialisations are counted. Move-only.
class EglDisplayUse {
 public:
  /// @throws Error (Environment) with EGL's reason.
  explicit EglDisplayUse(EGLDisplay display);
  ~EglDisplayUse();
  EglDisplayUse(EglDisplayUse&& other) noexcept;
  EglDisplayUse& operator=(EglDisplayUse&& other) noexcept;

  EGLDisplay get() const { return m_display; }
  bool has_extension(const char* name) const;

 private:
  EGLDisplay m_display = EGL_NO_DISPLAY;
};

/// EGL and its drivers do not survive a fork: a child of a process that has initialised a display
/// can neither use nor end it. Once a display is initialised, this is false in such a child.
bool egl_is_of_this_process();

/// The calling thread's last EGL error as text, for example "EGL_BAD_ALLOC (0x3003)".
std::string last_egl_error();

}  // namespace trivet
