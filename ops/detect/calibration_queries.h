// The fixed set of queries by which a machine's candidate finders are measured.
#pragma once

#include <memory>
#include <vector>

#include "core/contact/first_contact.h"

namespace trivet {

/// A body over, or beside, another one of the same generated shape, and its motion.
struct CalibrationQuery {
  std::shared_ptr<const Shape> shape;
  Affine moving, fixed;  // world from object
  Motion motion;

  /// Calls ask(const FirstContactQuery&).
  template <class Ask>
  void with_query(Ask&& ask) const {
    const Body a(*shape, moving), b(*shape, fixed);
    ask(FirstContactQuery{{&a, 1}, {&b, 1}, false, motion, {1e-6}});
  }
};

/// Queries with one kind of motion between two wavy spheres of about `num_triangles` triangles
/// each; their images are differently wide. All of them end in a contact.
std::vector<CalibrationQuery> calibration_queries(const std::shared_ptr<const Shape>& sphere,
                                                  Motion::Kind kind);

/// A sphere of radius 1 with waves; 8 n^2 triangles.
std::shared_ptr<const Shape> wavy_sphere(int n);

}  // namespace trivet
