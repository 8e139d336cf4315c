#include "ops/files/labels/data_sets.h"

namespace trivet {

std::vector<std::uint32_t> run_lengths(const std::vector<bool>& mask, int width, int height) {
  std::vector<std::uint32_t> out{0};
  bool value = false;
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < height; ++y) {
      if (const bool here = mask[std::size_t(y) * width + x]; here != value) {
        out.push_back(0);
        value = here;
      }
      ++out.back();
    }
  return out;
}

std::string compressed_run_lengths(const std::vector<std::uint32_t>& lengths) {
  constexpr int kBits = 5, kMore = 32, kFirst = 48;
  std::string out;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    // From the third on, the change since the last run of the same kind.
    std::int64_t rest = lengths[i];
    if (i > 2) rest -= lengths[i - 2];
    for (bool more = true; more;) {
      int piece = static_cast<int>(rest & 31);
      rest >>= kBits;
      more = piece & 16 ? rest != -1 : rest != 0;
      if (more) piece |= kMore;
      out += static_cast<char>(piece + kFirst);
    }
  }
  return out;
}

}  // namespace trivet
