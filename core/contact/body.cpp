#include "core/contact/body.h"

#include "core/base/outward.h"

namespace trivet {

Body::Body(const Shape& s, const Affine& m) : shape(&s), world_from_object(m) {
  if (!s.has_faces()) return;
  // The box is rounded outwards to float, as those of the tree are, and grown by the rounding of
  // its placement.
  const Aabb b = rounded_outwards(s.box);
  const Vec3 centre = m.apply(b.centre()), half = m.linear.cwiseAbs() * b.half_extent();
  const Vec3 margin = 1e-14 * (centre.cwiseAbs() + half);
  world_box = {centre - half - margin, centre + half + margin};
}

UnitFrame::UnitFrame(const Body& fixed)
    : unit_from_world((fixed.world_from_object.linear / fixed.scale()).transpose()),
      origin(fixed.world_from_object.translation) {}

}  // namespace trivet
