// SHA-256, by OpenSSL's libcrypto.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace trivet::farm {

using Digest = std::array<std::uint8_t, 32>;

class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void add(std::string_view bytes);
  /// Digest of all that was added. Called once.
  Digest digest();

 private:
  struct Context;
  std::unique_ptr<Context> m_context;
};

Digest sha256(std::string_view bytes);
/// 64 digits.
std::string hex(const Digest& digest);
inline std::string sha256_hex(std::string_view bytes) { return hex(sha256(bytes)); }

}  // namespace trivet::farm
