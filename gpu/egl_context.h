// A window-less OpenGL context. Start here for anything that runs on the graphics hardware.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace trivet {

struct EglOptions {
  bool allow_software = true;  // false: refuse renderers that run on the CPU
};

/// OpenGL core profile, 4.5 where there is one, else down to 3.3, without window or surface: draw
/// into framebuffer objects only. EGL devices are tried first, hardware before software, then
/// Mesa's surfaceless platform. The messages that drivers print are left alone.
///
/// Created with nothing current; make it current for a scope with `EglContext::Current`. At any
/// time at most one thread may have it current. Destroy GL objects while it is current.
class EglContext {
 public:
  /// @throws Error (Environment) that names every way tried and how each failed.
  explicit EglContext(const EglOptions& options = {});
  ~EglContext();
  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&& other) noexcept;

  /// GL_RENDERER, GL_VENDOR and GL_VERSION as the driver says them.
  const std::string& renderer() const;
  const std::string& vendor() const;
  const std::string& version() const;
  /// How it was reached, for example "EGL device 1 of 2".
  const std::string& device() const;
  /// The version of the context: 45 for OpenGL 4.5.
  int gl_version() const;
  /// Runs on the CPU: llvmpipe and the like.
  bool is_software() const;
  /// One line for reports: renderer, "(software)" where it is, version, device.
  std::string description() const;
  /// The ways that were tried before this one, each with its reason; empty when the first worked.
  const std::vector<std::string>& failures() const;

  class Current;
  class None;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

/// Makes a context current on this thread for a scope, then restores the EGL context that was
/// current before, so that it can be used inside somebody else's (the editor's) drawing.
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

/// Makes no context current for a scope: GL objects of a context that is lost may die there.
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
