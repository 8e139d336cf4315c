// Fingerprint of results, which ties figures to the computed answers.
#pragma once

#include <cstdint>
#include <cstring>

#include "core/contact/first_contact.h"
#include "core/motion/pose.h"

namespace trivet::perf {

/// FNV-1a, 64 bits, over the bits of the added values: the same on every machine and with any
/// number of threads, as long as Trivet's answers are the same.
class ResultHash {
 public:
  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) {
      m_hash ^= (bits >> (8 * byte)) & 0xff;
      m_hash *= 0x100000001b3;
    }
  }
  void add(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    add(bits);
  }
  void add(const Vec3& v) { add(v.x()), add(v.y()), add(v.z()); }
  void add(const Pose& pose) {
    add(pose.rotation.w), add(pose.rotation.x), add(pose.rotation.y), add(pose.rotation.z);
    add(pose.translation);
  }
  void add(const FirstContact& contact) {
    add(static_cast<std::uint64_t>(contact.status));
    if (contact.status == FirstContact::Status::Free) return;
    add(contact.time);
    add(static_cast<std::uint64_t>(contact.face_moving));
    add(static_cast<std::uint64_t>(contact.face_fixed));
  }
  std::uint64_t value() const { return m_hash; }

 private:
  std::uint64_t m_hash = 0xcbf29ce484222325;
};

}  // namespace trivet::perf
