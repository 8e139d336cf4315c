#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <new>
#include <optional>

#include "apps/farm/workers/zygote.h"
#include "core/base/error.h"

namespace trivet::farm {
namespace {

/// SIGPROF, which ends the process, after this CPU time of all its threads; 0: never.
void set_cpu_limit(double seconds) {
  const double whole = std::floor(seconds);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - whole) * 1e6);
  setitimer(ITIMER_PROF, &timer, nullptr);
}

std::string error_reply(const std::string& text, bool fatal) {
  const nlohmann::json json = {{"error", text}, {"fatal", fatal}};
  const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(json);
  return {bytes.begin(), bytes.end()};
}

/// Makes scenes; or pictures or exports of scenes that are there.
class Maker {
 public:
  Maker(const Work& work, const LoadedModels& models) : m_work(work), m_models(models) {
    if (const PictureWork* const pictures = work.pictures.get())
      m_scenes.emplace(pictures->folder, pictures->scenes.format);
    if (const ExportWork* const exports = work.exports.get())
      m_scenes.emplace(exports->folder, exports->scenes.format);
  }

  SceneMembers make(std::uint64_t k) {
    if (!m_scenes) return make_members(m_work, m_models, k);
    if (m_work.exports) return make_exports(*m_work.exports, *m_scenes, m_work.recipe, m_models, k);
    const PictureWork& pictures = *m_work.pictures;
    if (pictures.make_opengl && !m_opengl) m_opengl = pictures.make_opengl();
    return make_pictures(pictures, *m_scenes, m_work.recipe, m_models, m_work.key, k, m_opengl);
  }

 private:
  const Work& m_work;
  const LoadedModels& m_models;
  std::optional<SceneReader> m_scenes;
  DrawPicture m_opengl;
};

std::string reply_for(Maker& maker, const WorkLimits& limits, std::uint64_t k) {
  try {
    return reply_of(maker.make(k));
  } catch (const std::bad_alloc&) {
    return error_reply("needs more than " + std::to_string(limits.memory_mb) + " MB", true);
  } catch (const std::exception& e) {
    return error_reply(e.what(), false);
  }
}

}  // namespace

std::string reply_of(const SceneMembers& members) {
  nlohmann::json json = {{"scene", json_line(members.scene)}, {"more", nlohmann::json::array()}};
  for (const Member& member : members.more)
    json["more"].push_back(
        {member.name, nlohmann::json::binary({member.bytes.begin(), member.bytes.end()})});
  const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(json);
  return {bytes.begin(), bytes.end()};
}

void serve_scenes(const Work& work, const LoadedModels& models, const WorkLimits& limits,
                  int socket) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPROF, SIG_DFL);
  Maker maker(work, models);
  while (const auto request = receive_frame(socket)) {
    std::uint64_t k = 0;
    if (request->size() != sizeof k) _exit(1);
    std::memcpy(&k, request->data(), sizeof k);
    set_cpu_limit(limits.scene_seconds);
    const std::string reply = reply_for(maker, limits, k);
    set_cpu_limit(0);
    if (!send_frame(socket, reply)) _exit(1);
  }
  _exit(0);
}

}  // namespace trivet::farm
