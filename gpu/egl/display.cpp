#include "gpu/egl/display.h"

#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <iterator>
#include <map>
#include <mutex>
#include <sstream>
#include <utility>

#include "core/base/error.h"

namespace trivet {
namespace {

/// True if a blank-separated list contains the whole word.
bool has_word(const char* list, const std::string& word) {
  if (list == nullptr) return false;
  std::istringstream words(list);
  return std::find(std::istream_iterator<std::string>(words), {}, word) !=
         std::istream_iterator<std::string>();
}

/// libepoxy ends the process if it finds no library to load, so check first.
void require_libraries() {
  const auto loads = [](const char* name) { return dlopen(name, RTLD_LAZY | RTLD_LOCAL); };
  if (loads("libEGL.so.1") == nullptr) {
    const char* reason = dlerror();
    throw Error(Error::Kind::Environment,
                "no EGL: libEGL.so.1 cannot be loaded (%1); install libegl1",
                (reason != nullptr ? reason : "no reason given"));
  }
  if (loads("libOpenGL.so.0") == nullptr && loads("libGL.so.1") == nullptr)
    throw Error(Error::Kind::Environment,
                "no OpenGL: neither libOpenGL.so.0 nor libGL.so.1 can be loaded; install "
                "libopengl0");
}

EGLDisplay platform_display(EGLenum platform, void* native) {
  const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  return get == nullptr ? EGL_NO_DISPLAY : get(platform, native, nullptr);
}

std::vector<EGLDeviceEXT> list_devices(std::vector<std::string>& failures) {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!has_word(extensions, "EGL_EXT_platform_base") ||
      (!has_word(extensions, "EGL_EXT_device_enumeration") &&
       !has_word(extensions, "EGL_EXT_device_base"))) {
    failures.push_back("EGL devices: this EGL cannot list them (no EGL_EXT_device_enumeration)");
    return {};
  }
  const auto query =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLint count = 0;
  if (query == nullptr || !query(0, nullptr, &count) || count <= 0) {
    failures.push_back("EGL devices: none found");
    return {};
  }
  std::vector<EGLDeviceEXT> devices(count);
  if (!query(count, devices.data(), &count)) {
    failures.push_back("EGL devices: " + last_egl_error());
    count = 0;
  }
  devices.resize(std::max<EGLint>(count, 0));
  return devices;
}

bool is_software_device(EGLDeviceEXT device) {
  const auto query = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
      eglGetProcAddress("eglQueryDeviceStringEXT"));
  return query != nullptr && has_word(query(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

/// Number of live uses of each display.
struct UseCounts {
  std::mutex mutex;
  std::map<EGLDisplay, int> count;
};

UseCounts& use_counts() {
  static UseCounts counts;
  return counts;
}

/// The process that initialised the first display; 0: none.
std::atomic<pid_t> owner = 0;

void claim_egl() {
  pid_t none = 0;
  owner.compare_exchange_strong(none, getpid());
}

}  // namespace

std::vector<EglCandidate> list_egl_candidates(std::vector<std::string>& failures) {
  require_libraries();
  std::vector<EglCandidate> candidates;
  const std::vector<EGLDeviceEXT> devices = list_devices(failures);
  for (std::size_t i = 0; i < devices.size(); ++i) {
    EglCandidate candidate;
    candidate.device = static_cast<int>(i) + 1;
    candidate.name =
        "EGL device " + std::to_string(candidate.device) + " of " + std::to_string(devices.size());
    candidate.software = is_software_device(devices[i]);
    candidate.display = platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i]);
    if (candidate.display == EGL_NO_DISPLAY)
      failures.push_back(candidate.name + ": no display, " + last_egl_error());
    else
      candidates.push_back(candidate);
  }
  std::stable_partition(candidates.begin(), candidates.end(),
                        [](const EglCandidate& c) { return !c.software; });
  const EGLDisplay surfaceless =
      platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  if (surfaceless == EGL_NO_DISPLAY)
    failures.push_back("EGL surfaceless platform: no display, " + last_egl_error());
  else
    candidates.push_back({"EGL surfaceless platform", 0, surfaceless, false});
  return candidates;
}

EglDisplayUse::EglDisplayUse(EGLDisplay display) {
  claim_egl();
  UseCounts& uses = use_counts();
  const std::lock_guard lock(uses.mutex);
  int& count = uses.count[display];
  EGLint major = 0, minor = 0;
  if (!eglInitialize(display, &major, &minor))  // repeated in case other code has terminated it
    throw Error(Error::Kind::Environment, "eglInitialize failed, %1", last_egl_error());
  ++count;
  m_display = display;
}

EglDisplayUse::~EglDisplayUse() {
  if (m_display == EGL_NO_DISPLAY || !egl_is_of_this_process()) return;
  UseCounts& uses = use_counts();
  const std::lock_guard lock(uses.mutex);
  if (--uses.count[m_display] == 0) eglTerminate(m_display);
}

EglDisplayUse::EglDisplayUse(EglDisplayUse&& other) noexcept
    : m_display(std::exchange(other.m_display, EGL_NO_DISPLAY)) {}

EglDisplayUse& EglDisplayUse::operator=(EglDisplayUse&& other) noexcept {
  std::swap(m_display, other.m_display);
  return *this;
}

bool EglDisplayUse::has_extension(const char* name) const {
  return has_word(eglQueryString(m_display, EGL_EXTENSIONS), name);
}

bool egl_is_of_this_process() { return owner == 0 || owner == getpid(); }

std::string last_egl_error() {
  static constexpr std::pair<EGLint, const char*> kNames[] = {
      {EGL_SUCCESS, "EGL_SUCCESS"},
      {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
      {EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},
      {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
      {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"},
      {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
      {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT"},
      {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},
      {EGL_BAD_MATCH, "EGL_BAD_MATCH"},
      {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"},
      {EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST"},
      {EGL_BAD_DEVICE_EXT, "EGL_BAD_DEVICE_EXT"},
  };
  const EGLint code = eglGetError();
  char number[16];
  std::snprintf(number, sizeof number, "0x%04x", static_cast<unsigned>(code));
  for (const auto& [value, name] : kNames)
    if (value == code) return std::string(name) + " (" + number + ")";
  return std::string("EGL error ") + number;
}

}  // namespace trivet
