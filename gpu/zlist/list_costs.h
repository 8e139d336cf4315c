// Costs of lists in doubtful pixels, by a GPU and in software: for the choice per query.
#pragma once

#include <cstdint>

namespace trivet {

/// Milliseconds of a query's lists, with the pairs from them, beyond the depths. The number of
/// entries is not known before lists are made; faces and doubtful pixels determine it.
struct ListCost {
  double fixed_ms = 0, ms_per_face = 0, ms_per_doubtful = 0;

  double ms(double num_faces, double num_doubtful) const {
    return fixed_ms + ms_per_face * num_faces + ms_per_doubtful * num_doubtful;
  }
};

struct ListCosts {
  ListCost software, gpu;

  /// Up to so many doubtful pixels, lists in software are cheaper; 0: never, the largest number:
  /// always. Where a pixel costs the GPU no less than software, their number decides nothing.
  /// @param num_faces  of the bodies in the image.
  std::uint32_t most_in_software(double num_faces) const;
};

}  // namespace trivet
