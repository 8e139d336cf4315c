#include "apps/farm/recipe/sha256.h"

#include <openssl/evp.h>

#include <new>

#include "core/base/error.h"

namespace trivet::farm {

struct Sha256::Context {
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> state{EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

namespace {

void check(bool ok) {
  if (!ok) throw Error(Error::Kind::Environment, "libcrypto has no SHA-256");
}

}  // namespace

Sha256::Sha256() : m_context(std::make_unique<Context>()) {
  if (!m_context->state) throw std::bad_alloc();
  check(EVP_DigestInit_ex(m_context->state.get(), EVP_sha256(), nullptr) == 1);
}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(std::string_view bytes) {
  check(EVP_DigestUpdate(m_context->state.get(), bytes.data(), bytes.size()) == 1);
}

Digest Sha256::digest() {
  Digest out{};
  unsigned size = 0;
  check(EVP_DigestFinal_ex(m_context->state.get(), out.data(), &size) == 1 && size == out.size());
  return out;
}

Digest sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.digest();
}

std::string hex(const Digest& digest) {
  const char* const digits = "0123456789abcdef";
  std::string out;
  for (const std::uint8_t byte : digest) {
    out += digits[byte >> 4];
    out += digits[byte & 15];
  }
  return out;
}

}  // namespace trivet::farm
