// Expected cost of a query, from measurements of this machine.
#pragma once

#include <span>

#include "core/contact/first_contact.h"

namespace trivet {

/// Parameters of a query on which its cost depends.
struct QuerySize {
  Motion::Kind kind = Motion::Kind::Translation;
  double triangles = 0;  // of the bodies whose boxes meet during the motion
  double pixels = 0;     // of their common image, kPixelsAlong along its longer side

  static constexpr int kPixelsAlong = 128;
};

/// Size of a query, by stage 1 of z-lists. Cost O(pairs of bodies).
QuerySize size_of(const FirstContactQuery& query);

/// Milliseconds of a query with one kind of motion: the sum of its terms. z-lists draw every
/// triangle; BVHs visit about as many nodes as a curve on the surface crosses, so their cost grows
/// with the root.
struct CostModel {
  double fixed_ms = 0, ms_per_triangle = 0, ms_per_root = 0, ms_per_pixel = 0;

  double ms(const QuerySize& size) const;
};

/// A measured query.
struct CostSample {
  QuerySize size;
  double ms = 0;
};

/// Which term grows with the number of triangles.
enum class CostGrowth { Linear, Root };

/// Least squares of the relative errors, no term negative. BVHs have no image: with Root,
/// `ms_per_pixel` is 0.
/// @param samples  at least one; ms > 0.
CostModel fit_cost(std::span<const CostSample> samples, CostGrowth growth);

}  // namespace trivet
