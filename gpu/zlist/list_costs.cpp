#include "gpu/zlist/list_costs.h"

#include <limits>

namespace trivet {

std::uint32_t ListCosts::most_in_software(double num_faces) const {
  constexpr auto kAlways = std::numeric_limits<std::uint32_t>::max();
  // Software needs no draw for its lists: it may be ahead at first, and falls behind with each
  // doubtful pixel.
  const double ahead = gpu.ms(num_faces, 0) - software.ms(num_faces, 0);
  const double per_pixel = software.ms_per_doubtful - gpu.ms_per_doubtful;
  if (ahead < 0) return 0;
  if (per_pixel <= 0 || ahead >= per_pixel * kAlways) return kAlways;
  return static_cast<std::uint32_t>(ahead / per_pixel);
}

}  // namespace trivet
