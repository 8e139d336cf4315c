#include "core/io/process/protection.h"

namespace trivet {
namespace {

struct Part {
  const char* name;
  bool Protection::*there;
};
constexpr Part kParts[] = {{"landlock", &Protection::files},
                           {"seccomp", &Protection::calls},
                           {"network", &Protection::network},
                           {"mounts", &Protection::mounts},
                           {"privileges", &Protection::privileges}};

std::vector<std::string> parts(const Protection& protection, bool there) {
  std::vector<std::string> out;
  for (const Part& part : kParts)
    if (protection.*part.there == there) out.emplace_back(part.name);
  return out;
}

}  // namespace

std::vector<std::string> parts_of(const Protection& protection) { return parts(protection, true); }

std::vector<std::string> lacking_in(const Protection& protection) {
  return parts(protection, false);
}

std::string warning_about(const Protection& protection) {
  if (protection.whole()) return "";
  std::string lacking;
  if (!protection.files) lacking = "Landlock (Linux 5.13 or later)";
  if (!protection.calls) lacking += (lacking.empty() ? "" : " and ") + std::string("seccomp");
  return "models are read by a process of its own, but without " + lacking +
         ": a hostile model that takes it over could reach more than its folder";
}

std::uint8_t bits_of(const Protection& protection) {
  unsigned out = 0, bit = 1;
  for (const Part& part : kParts) {
    if (protection.*part.there) out |= bit;
    bit <<= 1;
  }
  return static_cast<std::uint8_t>(out);
}

Protection protection_of_bits(std::uint8_t bits) {
  Protection out;
  unsigned bit = 1;
  for (const Part& part : kParts) {
    out.*part.there = (bits & bit) != 0;
    bit <<= 1;
  }
  return out;
}

}  // namespace trivet
