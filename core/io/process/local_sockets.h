// Messages between processes over sockets. Private.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace trivet {

/// A descriptor, closed on destruction.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : m_number(number) {}
  ~Descriptor() { reset(); }
  Descriptor(Descriptor&& other) noexcept : m_number(other.m_number) { other.m_number = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept;
  int number() const { return m_number; }
  void reset();

 private:
  int m_number;
};

struct SocketPair {
  Descriptor a, b;
};
/// @param type  SOCK_STREAM or SOCK_SEQPACKET. @throws Error (Environment).
SocketPair socket_pair(int type);

/// Bytes of any number, over a stream. False, or nothing, when the other end is gone.
bool send_frame(int socket, std::string_view bytes);
std::optional<std::string> receive_frame(int socket);

/// A short message (up to kMaxMessage bytes), with a descriptor or without (-1), over a SEQPACKET.
inline constexpr size_t kMaxMessage = 8192;
bool send_message(int socket, std::string_view bytes, int descriptor = -1);
struct Message {
  std::string bytes;
  Descriptor descriptor;
};
std::optional<Message> receive_message(int socket);

}  // namespace trivet
