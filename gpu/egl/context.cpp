#include "gpu/egl/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "gpu/egl/display.h"
#include "gpu/egl/environment_error.h"

namespace trivet {
namespace {

constexpr int kVersions[] = {46, 45, 43, 41, 40, 33};

std::string gl_text(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

bool names_software(const std::string& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader", "Software Rasterizer"})
    if (renderer.find(name) != std::string::npos) return true;
  return false;
}

/// Contexts need no config if the driver supports EGL_KHR_no_config_context.
EGLConfig choose_config(const EglDisplayUse& display) {
  if (display.has_extension("EGL_KHR_no_config_context")) return EGL_NO_CONFIG_KHR;
  const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display.get(), wanted, &config, 1, &count) || count == 0)
    throw environment_error(say("no config for OpenGL, %1", last_egl_error()));
  return config;
}

/// @param notifies  asks for a context that is lost on a reset of the hardware, and tells.
EGLContext create_context(const EglDisplayUse& display, EGLConfig config, int version,
                          bool notifies) {
  const EGLint attributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,
      version / 10,
      EGL_CONTEXT_MINOR_VERSION,
      version % 10,
      EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
      notifies ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_KHR : EGL_NONE,
      EGL_LOSE_CONTEXT_ON_RESET_KHR,
      EGL_NONE};
  return eglCreateContext(display.get(), config, EGL_NO_CONTEXT, attributes);
}

}  // namespace

struct EglContext::State {
  explicit State(const EglCandidate& candidate) : display(candidate.display) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (context != EGL_NO_CONTEXT && egl_is_of_this_process())
      eglDestroyContext(display.get(), context);
  }
  void create(int most_version);

  EglDisplayUse display;
  EGLContext context = EGL_NO_CONTEXT;
  std::string renderer, vendor, version, device;
  int gl_version = 0;
  bool software = false;
  std::vector<std::string> failures;
};

void EglContext::State::create(int most_version) {
  if (!display.has_extension("EGL_KHR_surfaceless_context"))
    throw environment_error("cannot draw without a surface (no EGL_KHR_surfaceless_context)");
  if (!eglBindAPI(EGL_OPENGL_API)) throw environment_error(say("no OpenGL, %1", last_egl_error()));
  const EGLConfig config = choose_config(display);
  const bool may_notify = display.has_extension("EGL_EXT_create_context_robustness");
  for (const int wanted : kVersions) {
    if (wanted > most_version) continue;
    if (may_notify) context = create_context(display, config, wanted, true);
    if (context == EGL_NO_CONTEXT) context = create_context(display, config, wanted, false);
    if (context != EGL_NO_CONTEXT) break;
  }
  if (context == EGL_NO_CONTEXT)
    throw environment_error(say("no context of OpenGL 3.3 core or later, %1", last_egl_error()));
}

int egl_device_from_environment() {
  const char* const text = std::getenv("TRIVET_EGL_DEVICE");
  if (!text || !*text) return 0;
  int out = 0;
  const char* const end = text + std::strlen(text);
  const auto [rest, error] = std::from_chars(text, end, out);
  if (error == std::errc() && rest == end && out > 0) return out;
  throw environment_error(
      say("TRIVET_EGL_DEVICE is \"%1\"; accepted: the number of an EGL device, from 1", text));
}

EglContext::EglContext(const EglOptions& options) {
  if (!egl_is_of_this_process())
    throw environment_error("OpenGL was in use when this process was forked");
  std::vector<std::string> failures;
  for (const EglCandidate& candidate : list_egl_candidates(failures)) {
    if (options.device > 0 && candidate.device != options.device) continue;
    try {
      if (candidate.software && !options.allow_software)
        throw environment_error("software renderers are disabled");
      m_state = std::make_unique<State>(candidate);
      m_state->create(options.most_version);
      const Current current(*this);
      m_state->renderer = gl_text(GL_RENDERER);
      m_state->vendor = gl_text(GL_VENDOR);
      m_state->version = gl_text(GL_VERSION);
      m_state->device = candidate.name;
      m_state->gl_version = epoxy_gl_version();
      m_state->software = candidate.software || names_software(m_state->renderer);
      if (m_state->software && !options.allow_software)
        throw environment_error(
            say("%1 is a software renderer, and those are disabled", m_state->renderer));
      m_state->failures = std::move(failures);
      return;
    } catch (const Error& error) {
      failures.push_back(candidate.name + ": " + error.what());
      m_state.reset();
    }
  }
  std::string message = "no OpenGL 3.3 context through EGL";
  if (options.device > 0) message += " device " + std::to_string(options.device);
  message += failures.empty() ? ": there is none of this number" : "; tried:";
  for (const std::string& failure : failures) message += "\n  " + failure;
  throw environment_error(message);
}

EglContext::~EglContext() = default;
EglContext::EglContext(EglContext&& other) noexcept = default;
EglContext& EglContext::operator=(EglContext&& other) noexcept = default;

const std::string& EglContext::renderer() const { return m_state->renderer; }
const std::string& EglContext::vendor() const { return m_state->vendor; }
const std::string& EglContext::version() const { return m_state->version; }
const std::string& EglContext::device() const { return m_state->device; }
int EglContext::gl_version() const { return m_state->gl_version; }
bool EglContext::is_software() const { return m_state->software; }
const std::vector<std::string>& EglContext::failures() const { return m_state->failures; }

std::string EglContext::description() const {
  return renderer() + (is_software() ? " (software)" : "") + ", OpenGL " + version() + ", " +
         device();
}

EglContext::Current::Binding EglContext::Current::query() {
  // OpenGL ES and OpenGL may each have a current context: save that of the bound API first.
  Binding out;
  out.api = eglQueryAPI();
  out.context = eglGetCurrentContext();
  eglBindAPI(EGL_OPENGL_API);
  if (out.context == EGL_NO_CONTEXT) out.context = eglGetCurrentContext();
  out.display = eglGetCurrentDisplay();
  out.draw = eglGetCurrentSurface(EGL_DRAW);
  out.read = eglGetCurrentSurface(EGL_READ);
  return out;
}

void EglContext::Current::restore(const Binding& before, void* display) {
  if (before.context != EGL_NO_CONTEXT)
    eglMakeCurrent(before.display, before.draw, before.read, before.context);
  else if (display != EGL_NO_DISPLAY)
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglBindAPI(before.api);
}

EglContext::Current::Current(const EglContext& context) {
  if (!egl_is_of_this_process())
    throw environment_error("an OpenGL context of the process that this one was forked from");
  m_before = query();
  m_display = context.m_state->display.get();
  if (!eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, context.m_state->context)) {
    const std::string reason = last_egl_error();
    eglBindAPI(m_before.api);
    throw environment_error(
        say("cannot make the OpenGL context current on this thread, %1", reason));
  }
}

EglContext::Current::~Current() { restore(m_before, m_display); }

EglContext::None::None() : m_before(Current::query()) {
  if (m_before.context != EGL_NO_CONTEXT)
    eglMakeCurrent(m_before.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

EglContext::None::~None() { Current::restore(m_before, EGL_NO_DISPLAY); }

}  // namespace trivet
