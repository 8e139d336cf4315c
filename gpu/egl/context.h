// OpenGL context without a window. Start here for code that runs on the GPU.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace trivet {

/// Number in the environment variable TRIVET_EGL_DEVICE, from 1, as in "EGL device 1 of 2"; 0: it
/// is not set.   @throws Error (Environment) when it is no such number.
int egl_device_from_environment();

struct EglOptions {
  bool allow_software = true;                  // false: refuse renderers that run on the CPU
  int most_version = 46;                       // asks for no later OpenGL; drivers may give one
  int device = egl_device_from_environment();  // this EGL device alone; 0: the first that works
};

/// OpenGL core profile, 4.6 if available, else down to 3.3, without window or surface: draw into
/// framebuffer objects only. EGL devices are tried first, hardware before software, then Mesa's
/// surfaceless platform; or one device alone, for machines with several. Drivers' own messages are
/// not suppressed.
///
/// Not current after construction; make it current for a scope with `EglContext::Current`. At most
/// one thread may have it current at a time. Destroy GL objects while it is current. A child of a
/// process that has made one can neither use it nor make one: fork first.
class EglContext {
 public:
  /// @throws Error (Environment) that names every platform tried and how each failed.
  explicit EglContext(const EglOptions& options = {});
  ~EglContext();
  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&& other) noexcept;

  /// GL_RENDERER, GL_VENDOR and GL_VERSION as reported by the driver.
  const std::string& renderer() const;
  const std::string& vendor() const;
  const std::string& version() const;
  /// Platform in use, for example "EGL device 1 of 2".
  const std::string& device() const;
  /// The version of the context: 45 for OpenGL 4.5.
  int gl_version() const;
  /// True if it runs on the CPU, like llvmpipe.
  bool is_software() const;
  /// One line for reports: renderer, "(software)" if so, version, device.
  std::string description() const;
  /// Platforms tried before this one, each with the reason of its failure; empty if the first
  /// worked.
  const std::vector<std::string>& failures() const;

  class Current;
  class None;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

/// Makes a context current on this thread for a scope, then restores the previous EGL context, so
/// that it can be used inside another program's (the editor's) drawing.
class EglContext::Current {
 public:
  /// @throws Error (Environment) when EGL refuses, for instance because another thread has it.
  explicit Current(const EglContext& context);
  ~Current();
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;

 private:
  friend class None;
  struct Binding {
    void* display = nullptr;
    void* context = nullptr;
    void* draw = nullptr;
    void* read = nullptr;
    unsigned api = 0;
  };
  static Binding query();
  static void restore(const Binding& before, void* display);
  Binding m_before;
  void* m_display;
};

/// Makes no context current for a scope, so that GL objects of a lost context can be destroyed.
class EglContext::None {
 public:
  None();
  ~None();
  None(const None&) = delete;
  None& operator=(const None&) = delete;

 private:
  Current::Binding m_before;
};

}  // namespace trivet
