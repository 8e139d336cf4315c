#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <new>

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

std::string reply_for(const Work& work, const LoadedModels& models, const WorkLimits& limits,
                      std::uint64_t k) {
  try {
    return reply_of(make_members(work, models, k));
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
  while (const auto request = receive_frame(socket)) {
    std::uint64_t k = 0;
    if (request->size() != sizeof k) _exit(1);
    std::memcpy(&k, request->data(), sizeof k);
    set_cpu_limit(limits.scene_seconds);
    const std::string reply = reply_for(work, models, limits, k);
    set_cpu_limit(0);
    if (!send_frame(socket, reply)) _exit(1);
  }
  _exit(0);
}

}  // namespace trivet::farm
