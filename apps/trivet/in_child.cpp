#include "apps/trivet/in_child.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/io/process/local_sockets.h"
#include "core/io/sentence_json.h"

namespace trivet::apps {
namespace {

constexpr char kDoneMark = '+', kBadInputMark = '2', kEnvironmentMark = '3';

std::string answer_of(const std::function<std::string()>& work) {
  try {
    return kDoneMark + work();
  } catch (const Error& error) {
    const char kind = error.kind() == Error::Kind::BadInput ? kBadInputMark : kEnvironmentMark;
    return kind + to_json(error.sentence());
  } catch (const std::exception& error) {
    return kEnvironmentMark + to_json(Sentence(std::string(error.what())));
  }
}

}  // namespace

std::string in_child(const std::string& what, const std::function<std::string()>& work) {
  SocketPair ends = socket_pair(SOCK_SEQPACKET);
  const pid_t child = fork();
  if (child < 0) throw Error(Error::Kind::Environment, "no process to try %1 in", what);
  if (child == 0) {
    send_message(ends.b.number(), answer_of(work));
    _exit(0);
  }
  ends.b = Descriptor();
  const auto answer = receive_message(ends.a.number());
  waitpid(child, nullptr, 0);
  if (!answer) throw Error(Error::Kind::Environment, "%1 ended its process", what);
  const std::string text = answer->bytes.substr(1);
  if (answer->bytes[0] == kDoneMark) return text;
  throw Error(answer->bytes[0] == kBadInputMark ? Error::Kind::BadInput : Error::Kind::Environment,
              sentence_from_json(text));
}

}  // namespace trivet::apps
